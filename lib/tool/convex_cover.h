#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "lib/tool/compiled_tool.h"

// The tool as a stack of convex solids of revolution, for cheap bounds. Each solid is valid for the heights of its
// slab. Its signed distance is convex, so one subgradient bounds a whole triangle over a whole span of time. A cover's
// bound is never below the true value. If it is above it (undercuts, hollow ends, heights next to a step), the exact
// search decides. Proofs: docs/method/wide_sweep.md.

namespace gouge {

/// The solid {(r, z) : dist((r, z), core) <= radius}. The core is the region to the left of a convex chain of points.
/// The chain continues beyond both ends along its first and last segment.
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
  double foot_lo_mm = 0, foot_hi_mm = 0;                         ///< infinite if no element limits it
  double r_below_mm = 0, r_above_mm = 0;                         ///< 0: the whole end is free
  double r_closed_mm = std::numeric_limits<double>::infinity();  ///< finite if the chain contains the lower face
  double radius_mm = 0;
  std::vector<Vec2> chain;  ///< 2 to kMaxChain points
};

struct ConvexCover {
  std::vector<CoverPiece> pieces;  ///< from the tip up; empty for a tool without elements
  double size_mm = 0;              ///< maximum distance of the tool's points from its tip
};

/// Makes the cover. For a contour of many elements it follows chords and is farther from the tool, so that there are
/// few pieces.
/// Cost linear in the number of elements, and in the square of the number of pieces, which is at most a few hundred.
[[nodiscard]] ConvexCover make_convex_cover(const CompiledTool& tool);

/// Returns f of a piece at (r, z).
[[nodiscard]] double cover_distance(const CoverPiece& piece, const Vec2& q);

}  // namespace gouge
