#pragma once

#include "lib/check/prepared_scene.h"
#include "lib/geom/pose.h"

namespace gouge {

/// Returns how deep a drill is below the surface of the parts that surrounds it, from its tip, in mm; 0 where material
/// does not surround it, or a part is no solid. It is the same whether or not the parts have the hole.
///
/// `pose`: tip at the bottom of the hole. `radius_mm`: of the drill. `most_mm`: nothing above that height is examined.
/// Ensures  at each of eight directions about the axis, material stands beside the drill at a quarter of its radius up
///          to that depth, as far as 64 heights show; the upper end is known to 0.001 mm.
/// Cost     some 600 queries of a side.
[[nodiscard]] double depth_below_surface_mm(const Pose& pose, double radius_mm, double most_mm,
                                            const PreparedScene& scene);

}  // namespace gouge
