#pragma once

#include <array>

#include "lib/surface/surface.h"

namespace gouge {

/// A point of one surface, and the nearest point of another surface.
struct ClosestPair {
  Vec3 a = Vec3::Zero(), b = Vec3::Zero();
  double distance_mm = 0;
};

/// Returns the closest points of two triangles; if they meet, the points are the same up to rounding.
/// Cost  Constant, about a microsecond.
[[nodiscard]] ClosestPair closest_points(const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b);

/// Returns the closest points of surface `a` and of surface `b` moved by `shift`, in a's coordinates. Requires
/// triangles of both.
/// Ensures  The surfaces are nowhere nearer than distance_mm - 1e-9, unless distance_mm is at most `cutoff_mm`, at
///          which the search ends.
/// Cost     About O(log n) for surfaces apart; at most the number of pairs of facets within the distance.
[[nodiscard]] ClosestPair surface_distance(const Surface& a, const Surface& b, const Vec3& shift, double cutoff_mm = 0);

}  // namespace gouge
