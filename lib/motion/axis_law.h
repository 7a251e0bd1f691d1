#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "lib/geom/pose.h"
#include "lib/path/joint_angles.h"

// Motion of the tool between two positions where it is not that of CL data, as a kinematic chain gives it.

namespace gouge {

struct Toolpath;

/// Bounds of the way of a tip over an interval.
struct TipBounds {
  double length_mm = 0;        ///< the way is at most this long
  double acceleration_mm = 0;  ///< maximum of |tip''|, mm per square of a unit of t
};

/// The way of the tip from t = 0 to 1 of a move, where a law states it instead of the path. Part coordinates, mm.
/// Constant: several threads may call it. Between two of its kinks it is twice differentiable in t.
class TipPath {
 public:
  virtual ~TipPath() = default;

  /// Returns the tip; at 0 and 1 the ends of the move, to rounding.
  [[nodiscard]] virtual Vec3 tip_at(double t) const = 0;
  /// Returns bounds over [t0, t1]. Requires no kink inside it.
  [[nodiscard]] virtual TipBounds bounds(double t0, double t1) const = 0;
  /// Returns the instants in (0, 1), ascending, at which the speed of the tip or of the axis jumps.
  [[nodiscard]] virtual std::span<const double> kinks() const = 0;
};

/// Motions that a law admits for a move.
enum class LawScope {
  one,     ///< one motion
  circle,  ///< one motion: the tool axis on the great circle. At both ends the rotary joints state the turn about it
  documented,  ///< two motions: the tool axis on the great circle, and both rotary joints evenly
  any          ///< every motion whose rotary joints stay between their ends, with the tip anywhere on its line or curve
};

/// Bounds of the directions in a box of shares, about the directions at its middle. Radians.
struct TurnSpread {
  double axis_rad = 0;   ///< the tool axis departs by at most this angle
  double frame_rad = 0;  ///< all that is fixed to the tool departs by at most this turn
};

/// The way of the tool axis, and of all that is fixed to it, from t = 0 to 1 of a move. Constant: several threads may
/// call it.
class AxisPath {
 public:
  virtual ~AxisPath() = default;

  /// Directions of the tool in the part: x, y and the tool axis as columns of a rotation. Twice differentiable in t
  /// between two kinks of the tip.
  [[nodiscard]] virtual Eigen::Matrix3d axes_at(double t) const = 0;
  /// Bounds the angular velocity in [t0, t1]; radians per unit of t.
  [[nodiscard]] virtual double turn_rate_rad(double t0, double t1) const = 0;
  /// Bounds the derivative of the angular velocity in [t0, t1]; radians per square of a unit of t. Requires no kink inside
  /// the interval.
  [[nodiscard]] virtual double turn_acceleration_rad(double t0, double t1) const = 0;
  /// Returns the directions where the rotary joints have run these shares of their ways. None: the path is not one of
  /// rotary joints.
  [[nodiscard]] virtual std::optional<Eigen::Matrix3d> axes_at_shares(const TurnShares& /*shares*/) const {
    return std::nullopt;
  }
  /// Returns the spread of a box of shares. Requires a path of rotary joints.
  [[nodiscard]] virtual TurnSpread spread(const TurnShares& /*low*/, const TurnShares& /*high*/) const { return {}; }
  /// Null: the tip runs as the path states. Lives as long as this.
  [[nodiscard]] virtual const TipPath* tip_path() const { return nullptr; }
};

/// Returns the path of a tool that stands with these directions.
[[nodiscard]] std::shared_ptr<const AxisPath> standing_with(const Eigen::Matrix3d& axes);

/// Makes the way of the tool between two poses.
class AxisLaw {
 public:
  virtual ~AxisLaw() = default;

  /// Returns null where the law leaves the way open, but never for equal poses. Requires unit axes. The ends of the path
  /// are these poses, to rounding.
  [[nodiscard]] virtual std::shared_ptr<const AxisPath> between(const Pose& from, const Pose& to) const = 0;
  /// Returns the same for a move of a path. Its Toolpath::joints, whose history decides between several ways, and its
  /// tool count. Null: a motion that is in no path.
  [[nodiscard]] virtual std::shared_ptr<const AxisPath> of_move(const Toolpath* /*path*/, std::size_t /*move*/,
                                                                const Pose& from, const Pose& to) const {
    return between(from, to);
  }
  /// Returns the reason for which the law leaves the motion of a move with a start open. Empty: it does not, or opposite
  /// axes are the reason.
  [[nodiscard]] virtual std::string why_open(const Toolpath& /*path*/, std::size_t /*move*/) const { return {}; }
  /// Returns which motions the law admits. With `documented` and `any` the paths are those of rotary joints.
  [[nodiscard]] virtual LawScope scope() const { return LawScope::one; }
  /// Returns true where the tip may leave its line while the axis stands.
  [[nodiscard]] virtual bool bends_without_turning() const { return false; }
  /// Returns one word for options, reports and certificates.
  [[nodiscard]] virtual std::string name() const = 0;
};

}  // namespace gouge
