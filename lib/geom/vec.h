#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

// Vectors: Vec2 is a point or direction in the tool's (r, z) half plane, Vec3 one in space.

namespace gouge {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Box3 = Eigen::AlignedBox3d;

/// Returns the cross product, positive where `v` is to the left of `u`.
[[nodiscard]] inline double cross(const Vec2& u, const Vec2& v) { return u.x() * v.y() - u.y() * v.x(); }

/// Returns the largest coordinate of a box along a direction. Requires a box that is not empty.
[[nodiscard]] inline double highest_along(const Vec3& direction, const Box3& box) {
  return direction.cwiseProduct(box.min()).cwiseMax(direction.cwiseProduct(box.max())).sum();
}

}  // namespace gouge
