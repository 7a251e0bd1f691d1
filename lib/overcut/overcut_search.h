#pragma once

#include <cstddef>

#include "lib/overcut/swept_solid.h"
#include "lib/penetration/depth_body.h"

namespace gouge {

struct OvercutOptions {
  double gap_mm = 0.002;         ///< the search ends when nothing can be deeper by more than this ...
  double relative_gap = 0.01;    ///< ... or by more than this share,
  std::size_t most_cells = 400;  ///< or after so many cells
};

struct Overcut {
  double depth_mm = 0;        ///< realised at `point`: distance to the part's surface from inside
  double depth_upper_mm = 0;  ///< proven: nowhere is it more
  Vec3 point = Vec3::Zero();  ///< in the tool at t, mm, part coordinates
  double t = 0;
};

/// How far below the part's surface the tool reaches during the motion: the largest distance to the surface,
/// over every point of the part's inside that the tool takes up at any instant.
///
/// The distance is 1-Lipschitz and so is the tool's; a cell of space is given up when its centre's distance
/// plus its half diagonal is no more than what was found, or the tool does not come near. The best point is
/// then pushed on, within the tool, away from the surface.
///
/// Requires part.is_solid. `seed`: a point in the tool at `seed_t`, where the search begins.
/// Cost     at most `most_cells` searches for the nearest facet and as many of the motion.
/// Source   measure of thesis chapters 4 and 5; docs/algorithms/shallow_penetration.md, section 7.
[[nodiscard]] Overcut find_overcut(const SweptSolid& tool, const DepthBody& part, const Vec3& seed, double seed_t,
                                   const OvercutOptions& options = {});

}  // namespace gouge
