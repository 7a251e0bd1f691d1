#include "lib/hierarchy/distance_kernel.h"

#include "lib/base/instruction_sets.h"

namespace gouge {

namespace distance_plain {
extern const DistanceKernel kKernel;
}
#ifdef GOUGE_X86_KERNELS
namespace distance_avx2 {
extern const DistanceKernel kKernel;
}
namespace distance_avx512 {
extern const DistanceKernel kKernel;
}
#endif

std::span<const DistanceKernel* const> distance_kernels() {
  static constexpr std::array kernels{
      &distance_plain::kKernel,
#ifdef GOUGE_X86_KERNELS
      &distance_avx2::kKernel,
      &distance_avx512::kKernel,
#endif
  };
  return runnable(kernels);
}

const DistanceKernel& fastest_distance_kernel() {
  static const DistanceKernel& fastest = *distance_kernels().back();
  return fastest;
}

}  // namespace gouge
