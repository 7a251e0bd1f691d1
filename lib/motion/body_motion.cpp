#include "lib/motion/body_motion.h"

#include <cmath>

namespace gouge {
namespace {

Eigen::Matrix3d directions_at_start(const Motion& motion) {
  if (motion.axis_path()) return motion.axes_at(0);
  return motion.end_directions() ? (*motion.end_directions())[0] : rotation_to_axis(motion.start().axis);
}

}  // namespace

Eigen::Matrix3d rotation_to_axis(const Vec3& axis) {
  const double x = axis.x(), y = axis.y(), z = axis.z();
  // 1 + z, without the loss of digits near -z.
  const double up = z < 0 ? (x * x + y * y) / (1 - z) : 1 + z;
  if (!(up > 0)) return Vec3(1, -1, -1).asDiagonal();
  Eigen::Matrix3d turn;
  turn << 1 - x * x / up, -x * y / up, x, -x * y / up, 1 - y * y / up, y, -x, -y, z;
  return turn;
}

BodyMotion::BodyMotion(const Motion& motion) : motion_(motion), start_(directions_at_start(motion)) {
  if (motion.is_alone() || motion.axis_path()) return;
  const Eigen::Matrix3d end =
      motion.end_directions() ? (*motion.end_directions())[1] : rotation_to_axis(motion.end().axis);
  const Eigen::Matrix3d left = (motion.turn_to(1) * start_).transpose() * end;
  twist_rad_ = std::atan2(left(1, 0) - left(0, 1), left(0, 0) + left(1, 1));
}

RigidTransform BodyMotion::at(double t) const {
  const Eigen::AngleAxisd twist(twist_rad_ * t, Vec3::UnitZ());
  return {motion_.turn_to(t) * start_ * twist.toRotationMatrix(), motion_.at(t).tip};
}

// A turn about a fixed direction of the part and one about the tool axis, both at constant rate, are a product of two
// exponentials. Its second derivative is at most the square of the sum of both rates.
MotionRates BodyMotion::rates(double t0, double t1, std::uint32_t segment) const {
  MotionRates rates = motion_.rates(t0, t1, segment);
  rates.turn_rad += std::abs(twist_rad_) * (t1 - t0);
  return rates;
}

double BodyMotion::bulge_mm(const MotionInterval& interval, double distance_mm) const {
  if (!(interval.t1 > interval.t0)) return 0;
  const MotionRates over = rates(interval.t0, interval.t1, interval.segment);
  return over.bulge_mm(distance_mm + 0.5 * over.tip_path_mm);
}

}  // namespace gouge
