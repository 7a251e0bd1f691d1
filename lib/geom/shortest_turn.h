#pragma once

#include <Eigen/Geometry>

#include "lib/geom/vec.h"

namespace gouge {

/// Returns the rotation by the smallest angle that takes one unit vector to another. Between opposite vectors it is
/// half a turn about an axis perpendicular to them. (Eigen's FromTwoVectors computes the same by a singular value
/// decomposition. It adds five seconds to the compilation of each source that calls it.)
[[nodiscard]] inline Eigen::Quaterniond shortest_turn(const Vec3& from, const Vec3& to) {
  const double cosine = from.dot(to);
  Vec3 v = from.cross(to);
  v -= from.dot(v) * from;  // rounding is no small part of it near opposite vectors
  // 1 + cosine, without the loss of digits near opposite vectors.
  const double w = cosine < 0 ? v.squaredNorm() / (1 - cosine) : 1 + cosine;
  if (!(w > 0)) {
    const Vec3 across = from.unitOrthogonal();
    return {0, across.x(), across.y(), across.z()};
  }
  return Eigen::Quaterniond(w, v.x(), v.y(), v.z()).normalized();
}

}  // namespace gouge
