#pragma once

#include <cstdint>

#include "lib/base/best_first_search.h"
#include "lib/clash/clash_body.h"

namespace gouge {

/// Depth of one body in another: the largest distance to the other's surface over all points that
/// lie in both.
struct BodyDepth {
  double depth_mm = 0;          ///< realised at `point`
  double depth_upper_mm = 0;    ///< proven: no point of the one body inside the other is deeper
  Vec3 point = Vec3::Zero();    ///< of the one body, inside the other; coordinates of the other
  Vec3 normal = Vec3::UnitZ();  ///< unit; the shortest way out of the other body
  std::uint32_t triangle = 0;   ///< nearest one, index into the other's mesh
  bool is_decided = true;       ///< false: the budget ran out before the goal was reached
  std::uint64_t bounds = 0;
};

/// Finds the depth of `of` in `in`, where a point x of `of` lies at x + shift in the coordinates of `in`.
///
/// A deepest point is on the surface of `of`, or inside both where the distance to the surface of `in` has a local
/// maximum. So the search takes the triangles of `of`, and cells of space that may hold such a maximum.
///
/// Requires in.is_solid(). Where `of` is not a solid only its surface is examined. There `depth_mm` is still realised,
/// and `depth_upper_mm` bounds the surface alone.
/// Ensures  At any budget, depth <= true depth <= depth_upper. The same bits on every machine.
/// Cost     About 10 microseconds a bound. Plain bodies need a few hundred bounds. Where surfaces touch or run parallel
///          they need as many as pairs of facets lie over one another.
/// Source   Measure of thesis chapters 4 and 5; proof: docs/method/clash.md.
[[nodiscard]] BodyDepth find_body_depth(const ClashBody& of, const ClashBody& in, const Vec3& shift,
                                        const SearchGoal& goal);

}  // namespace gouge
