#pragma once

#include <cstdint>

#include "lib/base/best_first_search.h"
#include "lib/clash/clash_body.h"

namespace gouge {

/// Depth of one body in another: the largest distance to the other's surface, over all points that lie in both bodies.
struct BodyDepth {
  double depth_mm = 0;          ///< depth of `point`
  double depth_upper_mm = 0;    ///< proved upper bound of the depth of all points of the one body in the other
  Vec3 point = Vec3::Zero();    ///< a point of the one body, inside the other; coordinates of the other
  Vec3 normal = Vec3::UnitZ();  ///< unit direction of the shortest way out of the other body
  std::uint32_t triangle = 0;   ///< the nearest triangle, an index into the other's mesh
  bool is_decided = true;       ///< false: the budget ran out before the goal was reached
  std::uint64_t bounds = 0;
};

/// Finds the depth of `of` in `in`. A point x of `of` lies at x + shift in the coordinates of `in`.
///
/// A deepest point is either on the surface of `of`, or inside both bodies at a local maximum of the distance to the
/// surface of `in`. So the search takes the triangles of `of`, and cells of space that may contain such a maximum.
///
/// Requires in.is_solid(). If `of` is not a solid, only its surface is examined. Then `depth_mm` is still the depth of
/// a real point, and `depth_upper_mm` bounds only the surface.
/// Ensures  At any budget, depth <= true depth <= depth_upper. The result has the same bits on every machine.
/// Cost     About 10 microseconds for each bound. Simple bodies need a few hundred bounds. Surfaces that touch or run
///          parallel need as many bounds as pairs of facets lie over one another.
/// Source   Measure of thesis chapters 4 and 5; proof: docs/method/clash.md.
[[nodiscard]] BodyDepth find_body_depth(const ClashBody& of, const ClashBody& in, const Vec3& shift,
                                        const SearchGoal& goal);

}  // namespace gouge
