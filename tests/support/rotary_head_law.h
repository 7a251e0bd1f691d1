#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include "lib/motion/axis_law.h"

namespace gouge::test {

/// The law of a head with two rotary axes: C turns about z, and A about the x axis as turned by C. At 0 the tool is
/// upright. Between two positions both run at constant rates from one angle to the other, C the shorter way round.
class RotaryHeadLaw : public AxisLaw {
 public:
  [[nodiscard]] std::shared_ptr<const AxisPath> between(const Pose& from, const Pose& to) const override {
    double c0 = angle_c(from.axis), c1 = angle_c(to.axis);
    const double a0 = angle_a(from.axis), a1 = angle_a(to.axis);
    if (is_pole(from.axis)) c0 = c1;
    if (is_pole(to.axis)) c1 = c0;
    return std::make_shared<Path>(c0, std::remainder(c1 - c0, 2 * std::numbers::pi), a0, a1 - a0);
  }
  [[nodiscard]] std::string name() const override { return "rotary-head"; }

 private:
  class Path : public AxisPath {
   public:
    Path(double c0, double dc, double a0, double da) : c0_(c0), dc_(dc), a0_(a0), da_(da) {}
    [[nodiscard]] Eigen::Matrix3d axes_at(double t) const override {
      return (Eigen::AngleAxisd(c0_ + t * dc_, Vec3::UnitZ()) * Eigen::AngleAxisd(a0_ + t * da_, Vec3::UnitX()))
          .toRotationMatrix();
    }
    // The directions of both axes are perpendicular to each other; that of A turns with C.
    [[nodiscard]] double turn_rate_rad(double /*t0*/, double /*t1*/) const override { return std::hypot(dc_, da_); }
    [[nodiscard]] double turn_acceleration_rad(double /*t0*/, double /*t1*/) const override {
      return std::abs(dc_ * da_);
    }

   private:
    double c0_, dc_, a0_, da_;
  };

  static bool is_pole(const Vec3& axis) { return axis.head<2>().norm() < 1e-12; }
  static double angle_c(const Vec3& axis) { return std::atan2(axis.x(), -axis.y()); }
  static double angle_a(const Vec3& axis) { return std::atan2(axis.head<2>().norm(), axis.z()); }
};

}  // namespace gouge::test
