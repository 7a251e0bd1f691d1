#pragma once

#include <cmath>

#include "lib/check/motion.h"
#include "lib/check/motion_interval.h"
#include "lib/geom/rigid_transform.h"

namespace gouge {

/// Turns the part's z axis the shortest way to `axis` (about x where the axis is -z). It carries a body from
/// the tool's frame (origin at the tip, z along the tool axis) to the part's directions.
[[nodiscard]] Eigen::Matrix3d head_rotation(const Vec3& axis);

/// A body that is not a solid of revolution along a move. CL data say where the tool axis points, not how the
/// head is turned about it; at every position that is head_rotation. Between two, the axis runs on the great
/// circle as the tool's does, and what is left of the turn about the axis is spread evenly over the move.
class HeadMotion {
 public:
  /// Requires motion.is_defined(); the motion must outlive it.
  explicit HeadMotion(const Motion& motion);

  /// From the tool's frame to part coordinates at t.
  [[nodiscard]] RigidTransform at(double t) const;

  /// How far, in the tool's frame, the path of a point of the part over [t0, t1] may leave the straight chord
  /// between its positions at the ends; the point is at most `distance_mm` from the tip at t0.
  [[nodiscard]] double bulge_mm(double t0, double t1, std::uint32_t segment, double distance_mm) const;

  /// How far it turns over the whole move, about the tool axis and with it.
  [[nodiscard]] double turn_rad() const { return std::abs(motion_.angle_rad()) + std::abs(twist_rad_); }

  [[nodiscard]] const Motion& motion() const { return motion_; }

 private:
  const Motion& motion_;
  Eigen::Matrix3d start_;
  double twist_rad_ = 0;
};

/// A time interval of a head's motion, with the head's frames at its ends.
struct HeadInterval : MotionInterval {
  HeadInterval(const HeadMotion& motion, const MotionInterval& interval)
      : MotionInterval(interval), to_tool0(motion.at(t0).inverse()), to_tool1(motion.at(t1).inverse()) {}

  RigidTransform to_tool0, to_tool1;
};

}  // namespace gouge
