#pragma once

#include "lib/geom/pose.h"
#include "lib/geom/vec.h"

namespace gouge {

/// x -> rotation * x + shift, the rotation being a proper one. mm.
struct RigidTransform {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Vec3 shift = Vec3::Zero();

  [[nodiscard]] Vec3 point(const Vec3& x) const { return rotation * x + shift; }
  [[nodiscard]] Vec3 direction(const Vec3& x) const { return rotation * x; }
  [[nodiscard]] Pose pose(const Pose& p) const { return {point(p.tip), direction(p.axis)}; }
  [[nodiscard]] RigidTransform inverse() const { return {rotation.transpose(), -(rotation.transpose() * shift)}; }
};

}  // namespace gouge
