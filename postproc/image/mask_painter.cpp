#include "postproc/image/mask_painter.h"

#include <cstdlib>

#include "lib/base/shared_module.h"

namespace gouge {

Result<const MaskPainter*> mask_painter() {
  // If OpenCV was built with OpenBLAS, the latter starts a thread for every core when it is loaded. Masks need no
  // algebra.
  [[maybe_unused]] static const int is_set = ::setenv("OPENBLAS_NUM_THREADS", "1", 0);
  const Result<void*> make = find_function("gougecheck_pictures.so", "gougecheck_mask_painter");
  if (!make) return make.error();
  return reinterpret_cast<const MaskPainter* (*)()>(*make)();
}

}  // namespace gouge
