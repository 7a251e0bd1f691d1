#pragma once

#include "lib/geom/vec.h"

namespace gouge {

/// Pose of the tool: its tip, and its unit axis from the tip towards the spindle. Part coordinates, mm.
struct Pose {
  Vec3 tip = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();
};

/// The map x -> rotation * x + shift with a proper rotation. mm.
struct RigidTransform {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Vec3 shift = Vec3::Zero();

  [[nodiscard]] Vec3 point(const Vec3& x) const { return rotation * x + shift; }
  [[nodiscard]] Vec3 direction(const Vec3& x) const { return rotation * x; }
  [[nodiscard]] Pose pose(const Pose& p) const { return {point(p.tip), direction(p.axis)}; }
  [[nodiscard]] RigidTransform inverse() const { return {rotation.transpose(), -(rotation.transpose() * shift)}; }
};

}  // namespace gouge
