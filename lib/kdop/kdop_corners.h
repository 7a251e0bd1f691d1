#pragma once

#include <span>
#include <vector>

#include "lib/geom/vec.h"
#include "lib/kdop/directions.h"

namespace gouge {

struct Interval {
  double low = 0, high = 0;
};

/// Returns the interval of `points` along every axis; without points it is [0, 0].
[[nodiscard]] std::vector<Interval> intervals_of(const DirectionSet& directions, std::span<const Vec3> points);

/// Returns corner points of the polytope {x : low_i <= axis_i . x <= high_i}.
///
/// Shape    One point for each corner. Corners nearer to each other than 1e-9 of the polytope's size are listed once.
/// Ensures  The polytope lies in the hull of the corners offset by 1e-8 of its size. Tests check it with the enclosed
///          points in random directions.
/// Requires intervals that at least one point satisfies.
/// Cost     O(k^2) for small k: every face is a square clipped by all other half spaces.
/// Source   Thesis figure 13 and 6.1.1: at most 8, 24, 32 and 48 corners for k = 6, 14, 18, 26.
[[nodiscard]] std::vector<Vec3> kdop_corners(const DirectionSet& directions, std::span<const Interval> intervals);

}  // namespace gouge
