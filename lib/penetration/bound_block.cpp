#include "lib/penetration/bound_block.h"

#include "lib/base/instruction_sets.h"

namespace gouge {

namespace bounds_plain {
extern const BoundKernel kKernel;
}
#ifdef GOUGE_X86_KERNELS
namespace bounds_avx2 {
extern const BoundKernel kKernel;
}
namespace bounds_avx512 {
extern const BoundKernel kKernel;
}
#endif

std::size_t bound_kernel_count() {
#ifdef GOUGE_X86_KERNELS
  return instruction_sets();
#else
  return 1;
#endif
}

const BoundKernel& bound_kernel(std::size_t index) {
#ifdef GOUGE_X86_KERNELS
  if (index == 2) return bounds_avx512::kKernel;
  if (index == 1) return bounds_avx2::kKernel;
#endif
  static_cast<void>(index);
  return bounds_plain::kKernel;
}

const BoundKernel& fastest_bound_kernel() {
  static const BoundKernel& fastest = bound_kernel(bound_kernel_count() - 1);
  return fastest;
}

}  // namespace gouge
