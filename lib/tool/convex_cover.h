#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "lib/tool/compiled_tool.h"

// The tool as a stack of convex solids of revolution, for bounds that must be cheap. Each holds for the heights of its
// slab. Its signed distance is convex, so that one subgradient bounds a whole triangle and a whole span of time. A
// cover's bound is never below the true value. Where it is above (undercuts, hollow ends, heights next to a step) the
// exact search decides. Proofs: docs/method/wide_sweep.md.

namespace gouge {

/// The solid {(r, z) : dist((r, z), core) <= radius}. The core is the space on the left of a convex chain of points,
/// continued beyond both its ends along its first and last segment.
///
/// Let f = dist(core) - radius, negative inside. In the core, dist is the largest signed distance to a line of the
/// chain. Then for every q with z in [z_lo, z_hi]:
///   (1) f(q) >= 0:  q is not in the interior of the tool.
///   (2) f(q) = -d < 0, z + d < foot_hi, and z - d > foot_lo or r >= r_closed:  depth(q) <= d.
///   (3) r >= r_below:  depth(q) <= z - z_lo;      r >= r_above:  depth(q) <= z_hi - z.
///   (4) The part of the tool within the slab is no closer to any point p than max(f(p), z_lo - p.z, p.z - z_hi).
/// The slabs of a cover reach from the lowest point of the tool to the highest.
struct CoverPiece {
  static constexpr std::size_t kMaxChain = 12;
  double z_lo_mm = 0, z_hi_mm = 0;
  double foot_lo_mm = 0, foot_hi_mm = 0;                         ///< infinite where nothing follows
  double r_below_mm = 0, r_above_mm = 0;                         ///< 0: the whole end is free
  double r_closed_mm = std::numeric_limits<double>::infinity();  ///< finite where the chain has the lower face
  double radius_mm = 0;
  std::vector<Vec2> chain;  ///< 2 to kMaxChain points
};

struct ConvexCover {
  std::vector<CoverPiece> pieces;  ///< from the tip up; empty for a tool without elements
  double size_mm = 0;              ///< no point of the tool is farther from its tip
};

/// Makes the cover. That of a contour of many elements stands off by more: it follows chords, so that its pieces stay
/// few.
/// Cost linear in the number of elements, and in the square of pieces, which are some hundred at the most.
[[nodiscard]] ConvexCover make_convex_cover(const CompiledTool& tool);

/// Returns f of a piece at (r, z).
[[nodiscard]] double cover_distance(const CoverPiece& piece, const Vec2& q);

}  // namespace gouge
