#pragma once

#include <array>

#include "lib/surface/surface.h"

namespace gouge {

/// A point of one surface and the nearest to it of another.
struct ClosestPair {
  Vec3 a = Vec3::Zero(), b = Vec3::Zero();
  double distance_mm = 0;
};

/// Returns the closest points of two triangles; the same point, up to rounding, where they meet.
/// Cost  Constant, about a microsecond.
[[nodiscard]] ClosestPair closest_points(const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b);

/// Returns the closest points of surface `a` and of surface `b` moved by `shift`, in a's coordinates. Requires
/// triangles of both.
/// Ensures  Nowhere are they nearer than distance_mm - 1e-9, unless that is at most `cutoff_mm`, where the search ends.
/// Cost     About O(log n) for surfaces apart; no more than the pairs of facets within their distance.
[[nodiscard]] ClosestPair surface_distance(const Surface& a, const Surface& b, const Vec3& shift, double cutoff_mm = 0);

}  // namespace gouge
