#pragma once

#include <cstddef>

#include "lib/overcut/swept_solid.h"
#include "lib/surface/surface.h"

namespace gouge {

struct OvercutOptions {
  std::size_t max_cells =
      5'000;                ///< the search ends when the two bounds are overcut_gap_mm apart, or after so many cells
  bool ends_early = false;  ///< a climb ends once the two bounds are overcut_gap_mm apart
};

struct Overcut {
  double depth_mm = 0;        ///< depth of `point`: its distance to the part's surface from inside
  double depth_upper_mm = 0;  ///< proved upper bound of the depth
  Vec3 point = Vec3::Zero();  ///< a point in the tool at t; mm, part coordinates
  double t = 0;
};

/// Finds how far below the part's surface the solid reaches during the motion. That is the largest distance to the
/// surface, over all points inside the part that are in the solid at some instant.
///
/// The search is best first over cells of space and time. The part of the solid in a cell lies behind planes that touch
/// it. The part of the workpiece in the cell lies below a plane over all of the surface there. That plane is square to
/// the direction of the closest point to the cell's middle. A linear program bounds the cell to second order in its
/// size.
///
/// Requires the boundary of a solid (Surface::boundary). `seed` is a point in the solid at `seed_t`, where the search
/// begins.
/// Cost     Some microseconds for each cell. A solid that is blunt wherever it is in the part needs no cell; a corner
///          there needs some dozens.
/// Source   Measure of thesis chapters 4 and 5; proof: docs/method/overcut.md.
[[nodiscard]] Overcut find_overcut(SweptSolid& solid, const Surface& part, const Vec3& seed, double seed_t,
                                   const OvercutOptions& options = {});

}  // namespace gouge
