#include "lib/head/head_motion.h"

#include <cmath>

namespace gouge {
namespace {

constexpr double kOpposite = 1e-9;

}  // namespace

Eigen::Matrix3d head_rotation(const Vec3& axis) {
  if (1 + axis.z() < kOpposite) return Vec3(1, -1, -1).asDiagonal();
  Eigen::Matrix3d cross;
  const Vec3 v = Vec3::UnitZ().cross(axis);
  cross << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return Eigen::Matrix3d::Identity() + cross + cross * cross / (1 + axis.z());
}

HeadMotion::HeadMotion(const Motion& motion) : motion_(motion), start_(head_rotation(motion.start().axis)) {
  if (motion.is_alone()) return;
  const Eigen::AngleAxisd turn(motion.angle_rad(), motion.rotation_axis());
  const Eigen::Matrix3d left = (turn.toRotationMatrix() * start_).transpose() * head_rotation(motion.end().axis);
  twist_rad_ = std::atan2(left(1, 0) - left(0, 1), left(0, 0) + left(1, 1));
}

RigidTransform HeadMotion::at(double t) const {
  const Eigen::AngleAxisd turn(motion_.angle_rad() * t, motion_.rotation_axis());
  const Eigen::AngleAxisd twist(twist_rad_ * t, Vec3::UnitZ());
  return {turn.toRotationMatrix() * start_ * twist.toRotationMatrix(), motion_.at(t).tip};
}

// The second derivative of the point's path is at most (rate)^2 distance + 2 rate speed, both rates added up;
// a chord over a unit of time leaves such a path by an eighth of that. What the tip itself leaves its chord
// comes on top.
double HeadMotion::bulge_mm(double t0, double t1, std::uint32_t segment, double distance_mm) const {
  const double path_length = motion_.path_length_mm(t0, t1, segment);
  const double turn = (std::abs(motion_.angle_rad()) + std::abs(twist_rad_)) * (t1 - t0);
  return (turn * turn * (distance_mm + path_length) + 2 * turn * path_length) / 8 + motion_.sag_mm(t0, t1, segment);
}

}  // namespace gouge
