#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "lib/geom/vec.h"
#include "lib/path/joint_angles.h"

// Motion of the tool axis between two positions where it is not on the great circle, as a kinematic chain gives it.

namespace gouge {

/// The way of the tool axis, and of all that is fixed to it, from t = 0 to 1 of a move. Constant: several threads may
/// call it.
class AxisPath {
 public:
  virtual ~AxisPath() = default;

  /// Directions of the tool in the part: x, y and the tool axis as columns of a rotation. Twice differentiable in t.
  [[nodiscard]] virtual Eigen::Matrix3d axes_at(double t) const = 0;
  /// Bounds the angular velocity in [t0, t1]; radians per unit of t.
  [[nodiscard]] virtual double turn_rate_rad(double t0, double t1) const = 0;
  /// Bounds the derivative of the angular velocity in [t0, t1]; radians per square of a unit of t.
  [[nodiscard]] virtual double turn_acceleration_rad(double t0, double t1) const = 0;
};

/// Makes the way of the axis between two directions.
class AxisLaw {
 public:
  virtual ~AxisLaw() = default;

  /// Returns null where the law leaves the way open, but never for equal directions. Requires unit directions. The ends
  /// of the path are these directions, to rounding.
  [[nodiscard]] virtual std::shared_ptr<const AxisPath> between(const Vec3& from, const Vec3& to) const = 0;
  /// Returns the same for a move of a path with the angles of `joints`, whose history decides between several ways; may
  /// be null.
  [[nodiscard]] virtual std::shared_ptr<const AxisPath> of_move(const JointPath* /*joints*/, std::size_t /*move*/,
                                                                const Vec3& from, const Vec3& to) const {
    return between(from, to);
  }
  /// Returns one word for options, reports and certificates.
  [[nodiscard]] virtual std::string name() const = 0;
};

}  // namespace gouge
