#pragma once

#include <cmath>

#include "lib/geom/pose.h"
#include "lib/motion/motion.h"
#include "lib/motion/motion_interval.h"

namespace gouge {

/// Turns the part's z axis the shortest way to `axis` (about x where the axis is -z). It carries a body from
/// the tool's frame (origin at the tip, z along the tool axis) to the part's directions.
[[nodiscard]] Eigen::Matrix3d rotation_to_axis(const Vec3& axis);

/// A body that is not a solid of revolution along a move. On the great circle CL data state where the tool axis points,
/// not how the body is turned about it. At every position that is rotation_to_axis, or what the rotary joints of a machine
/// state. Between two, the axis runs on the great circle as the tool's does. The rest of the turn, about the axis, is
/// spread evenly over the move. An AxisLaw with a path states all of it.
class BodyMotion {
 public:
  /// Requires motion.is_defined(); the motion must outlive it.
  explicit BodyMotion(const Motion& motion);

  /// Returns the transform from the tool's frame to part coordinates at t.
  [[nodiscard]] RigidTransform at(double t) const;
  /// Returns bounds over [t0, t1] of a segment.
  [[nodiscard]] MotionRates rates(double t0, double t1, std::uint32_t segment) const;
  /// Bounds the distance, in the tool's frame, of the path of a point of the part over the interval from its chord. The
  /// chord joins its positions at the ends. The point is at most `distance_mm` from the tip at one end. 0 for an
  /// instant.
  [[nodiscard]] double bulge_mm(const MotionInterval& interval, double distance_mm) const;
  /// Bounds its turn over the whole move, about the tool axis and with it.
  [[nodiscard]] double turn_rad() const { return motion_.turn_rad() + std::abs(twist_rad_); }

  [[nodiscard]] const Motion& motion() const { return motion_; }

 private:
  const Motion& motion_;
  Eigen::Matrix3d start_;  // from the tool's frame to the part's directions at the start
  double twist_rad_ = 0;   // about the tool axis, over the whole move
};

/// A time interval of a body's motion, with the body's frames at its ends.
struct BodyInterval : MotionInterval {
  BodyInterval(const BodyMotion& motion, const MotionInterval& interval)
      : MotionInterval(interval), to_tool0(motion.at(t0).inverse()), to_tool1(motion.at(t1).inverse()) {}

  RigidTransform to_tool0, to_tool1;
};

}  // namespace gouge
