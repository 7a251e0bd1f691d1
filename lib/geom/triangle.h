#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "lib/geom/vec.h"

namespace gouge {

/// Returns the first of the longest edges as `k`: the edge from corner `k` to the next one.
[[nodiscard]] inline std::size_t longest_edge(const std::array<Vec3, 3>& t) {
  std::size_t longest = 0;
  double length2 = (t[1] - t[0]).squaredNorm();
  for (std::size_t k = 1; k < 3; ++k) {
    const double other2 = (t[(k + 1) % 3] - t[k]).squaredNorm();
    if (!(other2 > length2)) continue;
    length2 = other2;
    longest = k;
  }
  return longest;
}

/// Returns both halves of a triangle that is cut at the middle of an edge. The first half contains the end of the edge,
/// the second half its start.
[[nodiscard]] inline std::array<std::array<Vec3, 3>, 2> halves(const std::array<Vec3, 3>& t, std::size_t edge) {
  const std::size_t next = (edge + 1) % 3;
  const Vec3 middle = 0.5 * (t[edge] + t[next]);
  std::array<std::array<Vec3, 3>, 2> parts{t, t};
  parts[0][edge] = parts[1][next] = middle;
  return parts;
}

/// Returns the distance of `point` from the line segment from `a` to `b`, which may be one point. The unit is that of
/// the points. The points are Eigen vectors of one kind in one frame.
template <class Vector>
[[nodiscard]] double distance_to_segment(const Vector& point, const Vector& a, const Vector& b) {
  const Vector along = b - a;
  const double length2 = along.squaredNorm();
  const double t = length2 > 0 ? std::clamp((point - a).dot(along) / length2, 0.0, 1.0) : 0.0;
  return (point - a - t * along).norm();
}

}  // namespace gouge
