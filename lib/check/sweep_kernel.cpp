#include "lib/check/sweep_kernel.h"

#include <algorithm>
#include <cmath>

#include "lib/base/instruction_sets.h"
#include "lib/base/tolerance.h"
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

namespace {

/// Returns the direction of a line in a chain; upright if it leans only by rounding.
Vec2 along(const std::vector<Vec2>& chain, std::size_t line) {
  const Vec2 displacement = (chain[line + 1] - chain[line]).normalized();
  return std::abs(displacement.x()) < Tolerance::kSameDirection ? Vec2(0, displacement.y() < 0 ? -1 : 1) : displacement;
}

void set_core(const CoverPiece& piece, double size, KernelPiece& k) {
  const std::vector<Vec2>& chain = piece.chain;
  double widest = 0, narrowest = 0, reach = 0;
  for (std::size_t i = 1; i + 1 < chain.size(); ++i) {
    widest = std::max(widest, chain[i].x());
    narrowest = std::min(narrowest, chain[i].x());
    reach = std::max(reach, chain[i].lpNorm<1>());
  }
  if (k.count == 1) widest = std::max(chain[0].x(), chain[1].x());
  k.core_r_mm = widest > Tolerance::kRounding * size ? static_cast<float>(widest) : 0.0F;
  k.is_steady = k.count > 1 && narrowest >= -Tolerance::kRounding * size;
  if (!k.is_steady) return;
  k.is_level_below = std::abs(along(chain, 0).y()) < Tolerance::kSameDirection;
  k.is_level_above = std::abs(along(chain, k.count - 1).y()) < Tolerance::kSameDirection;
  k.is_pin = k.count == 2 && !(k.core_r_mm > 0) && k.is_level_below && std::abs(along(chain, 1).x()) <= 0;
  k.is_disc = !k.is_sharp && k.core_r_mm > 0 && k.is_level_below && k.core_r_mm <= k.lines[1].r;
  k.core_mm = static_cast<float>(reach);
}

}  // namespace

KernelPiece kernel_piece(const CoverPiece& piece) {
  KernelPiece k;
  double size = std::max(std::abs(piece.z_lo_mm), std::abs(piece.z_hi_mm)) + piece.radius_mm;
  k.count = static_cast<std::uint32_t>(piece.chain.size() - 1);
  for (std::size_t i = 0; i + 1 < piece.chain.size(); ++i) {
    const Vec2 displacement = along(piece.chain, i);
    const Vec2& base = i == 0 ? piece.chain[1] : piece.chain[i];
    const Vec2 at = piece.chain.size() == 2 ? Vec2(0.5 * (piece.chain[0] + piece.chain[1])) : base;
    k.lines[i] = {static_cast<float>(at.x()),
                  static_cast<float>(at.y()),
                  static_cast<float>(displacement.x()),
                  static_cast<float>(displacement.y()),
                  0,
                  0};
    size = std::max(size, at.norm());
    if (i == 0) continue;
    const Vec2 before = along(piece.chain, i - 1);
    const Vec2 in =
        Vec2(-before.y() - displacement.y(), before.x() + displacement.x()) / (1 + before.dot(displacement));
    k.lines[i].in_r = static_cast<float>(in.x());
    k.lines[i].in_z = static_cast<float>(in.y());
  }
  k.is_sharp = k.count > 1 && piece.radius_mm < Tolerance::kWitness_mm;
  k.radius_mm = static_cast<float>(piece.radius_mm);
  k.z_lo_mm = static_cast<float>(piece.z_lo_mm);
  k.z_hi_mm = static_cast<float>(piece.z_hi_mm);
  k.foot_lo_mm = static_cast<float>(piece.foot_lo_mm);
  k.foot_hi_mm = static_cast<float>(piece.foot_hi_mm);
  k.r_closed_mm = static_cast<float>(piece.r_closed_mm);
  // An end that is free everywhere stays free, in whatever way the least radius is rounded.
  k.r_below_mm = piece.r_below_mm > 0 ? static_cast<float>(piece.r_below_mm) : -3e38F;
  k.r_above_mm = piece.r_above_mm > 0 ? static_cast<float>(piece.r_above_mm) : -3e38F;
  set_core(piece, size, k);
  k.rounding_mm = static_cast<float>(Tolerance::kSingleSum * size);
  return k;
}

std::span<const SweepKernel* const> sweep_kernels() {
  static constexpr std::array kernels{
      &kernel_plain::kKernel,
#ifdef GOUGE_X86_KERNELS
      &kernel_avx2::kKernel,
      &kernel_avx512::kKernel,
#endif
  };
  return runnable(kernels);
}

const SweepKernel& fastest_sweep_kernel() { return *sweep_kernels().back(); }

}  // namespace gouge
