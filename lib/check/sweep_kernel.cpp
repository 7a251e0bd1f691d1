#include "lib/check/sweep_kernel.h"

#include <algorithm>
#include <cmath>

#include "lib/tool/convex_cover.h"

namespace gouge {

namespace kernel_plain {
extern const SweepKernel kKernel;
}
#ifdef GOUGE_X86_KERNELS
namespace kernel_avx2 {
extern const SweepKernel kKernel;
}
namespace kernel_avx512 {
extern const SweepKernel kKernel;
}
#endif

static_assert(KernelPiece::kMaxLines + 1 == CoverPiece::kMaxChain);

KernelPiece kernel_piece(const CoverPiece& piece) {
  KernelPiece k;
  double size = std::max(std::abs(piece.z_lo_mm), std::abs(piece.z_hi_mm)) + piece.radius_mm;
  k.count = static_cast<std::uint32_t>(piece.chain.size() - 1);
  for (std::size_t i = 0; i + 1 < piece.chain.size(); ++i) {
    const Vec2 along = (piece.chain[i + 1] - piece.chain[i]).normalized();
    const Vec2& base = i == 0 ? piece.chain[1] : piece.chain[i];
    const Vec2 at = piece.chain.size() == 2 ? Vec2(0.5 * (piece.chain[0] + piece.chain[1])) : base;
    k.lines[i] = {static_cast<float>(at.x()), static_cast<float>(at.y()), static_cast<float>(along.x()),
                  static_cast<float>(along.y())};
    size = std::max(size, at.norm());
  }
  k.radius_mm = static_cast<float>(piece.radius_mm);
  k.z_lo_mm = static_cast<float>(piece.z_lo_mm);
  k.z_hi_mm = static_cast<float>(piece.z_hi_mm);
  k.foot_lo_mm = static_cast<float>(piece.foot_lo_mm);
  k.foot_hi_mm = static_cast<float>(piece.foot_hi_mm);
  k.r_closed_mm = static_cast<float>(piece.r_closed_mm);
  // A whole end that is free stays free however the least radius is rounded.
  k.r_below_mm = piece.r_below_mm > 0 ? static_cast<float>(piece.r_below_mm) : -3e38F;
  k.r_above_mm = piece.r_above_mm > 0 ? static_cast<float>(piece.r_above_mm) : -3e38F;
  k.rounding_mm = static_cast<float>(1e-6 * size);
  return k;
}

std::size_t sweep_kernel_count() {
#ifdef GOUGE_X86_KERNELS
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq"))
    return 3;
  if (__builtin_cpu_supports("avx2")) return 2;
#endif
  return 1;
}

const SweepKernel& sweep_kernel(std::size_t index) {
#ifdef GOUGE_X86_KERNELS
  if (index == 2) return kernel_avx512::kKernel;
  if (index == 1) return kernel_avx2::kKernel;
#endif
  static_cast<void>(index);
  return kernel_plain::kKernel;
}

const SweepKernel& fastest_sweep_kernel() {
  static const SweepKernel& fastest = sweep_kernel(sweep_kernel_count() - 1);
  return fastest;
}

}  // namespace gouge
