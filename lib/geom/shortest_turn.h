#pragma once

#include <Eigen/Geometry>

#include "lib/base/tolerance.h"
#include "lib/geom/vec.h"

namespace gouge {

/// Returns the rotation by the smallest angle that takes one unit vector to another. Between opposite vectors it is
/// half a turn about an axis perpendicular to them. (Eigen's FromTwoVectors computes the same by a singular value
/// decomposition. It adds five seconds to the compilation of each source that calls it.)
[[nodiscard]] inline Eigen::Quaterniond shortest_turn(const Vec3& from, const Vec3& to) {
  const double w = 1 + from.dot(to);
  if (w < Tolerance::kNoDirection) {
    const Vec3 across = from.unitOrthogonal();
    return {0, across.x(), across.y(), across.z()};
  }
  const Vec3 v = from.cross(to);
  return Eigen::Quaterniond(w, v.x(), v.y(), v.z()).normalized();
}

}  // namespace gouge
