#pragma once

#include <algorithm>

namespace gouge {

/// Distance of `point` from the line segment from `a` to `b`, which may be one point; in the unit of the points, which
/// are Eigen vectors of one kind in one frame.
template <class Vector>
[[nodiscard]] double distance_to_segment(const Vector& point, const Vector& a, const Vector& b) {
  const Vector along = b - a;
  const double length2 = along.squaredNorm();
  const double t = length2 > 0 ? std::clamp((point - a).dot(along) / length2, 0.0, 1.0) : 0.0;
  return (point - a - t * along).norm();
}

}  // namespace gouge
