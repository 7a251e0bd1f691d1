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

std::span<const BoundKernel* const> bound_kernels() {
  static constexpr std::array kernels{
      &bounds_plain::kKernel,
#ifdef GOUGE_X86_KERNELS
      &bounds_avx2::kKernel,
      &bounds_avx512::kKernel,
#endif
  };
  return runnable(kernels);
}

const BoundKernel& fastest_bound_kernel() { return *bound_kernels().back(); }

}  // namespace gouge
