#include "postproc/image/mask_painter.h"

#include "lib/base/shared_module.h"

namespace gouge {

Result<const MaskPainter*> mask_painter() {
  const Result<void*> make = find_function("gougecheck_pictures.so", "gougecheck_mask_painter");
  if (!make) return make.error();
  return reinterpret_cast<const MaskPainter* (*)()>(*make)();
}

}  // namespace gouge
