#pragma once

#include <array>
#include <numbers>
#include <vector>

#include "lib/geom/pose.h"
#include "lib/machine/machine.h"
#include "lib/path/joint_angles.h"

// Forward and inverse kinematics of a chain with two rotary joints. Proof and figures: docs/method/machine.md.

namespace gouge {

inline constexpr double kWholeTurn_rad = 2 * std::numbers::pi;

/// Returns the directions of the tool in the part: x, y and the tool axis as columns.
[[nodiscard]] Eigen::Matrix3d tool_axes(const Machine& machine, const RotaryAngles& angles);

/// Solutions of the inverse problem for one tool axis, each angle within (-pi, pi].
struct RotarySolutions {
  std::vector<RotaryAngles> all;  ///< none, one or two
  /// The first joint turns the tool about its own axis there, so that any of its angles serves. `all` then has its
  /// angle 0.
  bool is_pole = false;
};
/// Requires a unit axis. Ensures: tool_axes of each solution has `axis` as its third column, to 1e-12 away from poles.
/// At the rim of the reachable axes both solutions fall together.
[[nodiscard]] RotarySolutions rotary_angles(const Machine& machine, const Vec3& axis);

/// Values of all joints in the order of Machine::joints, mm and rad.
using JointValues = std::vector<double>;

/// Returns tip and tool axis in part coordinates. `tool_length_mm`: from the gauge point to the tip.
[[nodiscard]] Pose forward(const Machine& machine, const JointValues& joints, double tool_length_mm);

/// Returns the linear joints that bring the tip to its place with these rotary angles, and all values in their order.
[[nodiscard]] JointValues inverse(const Machine& machine, const Vec3& tip, const RotaryAngles& angles,
                                  double tool_length_mm);

/// Returns the volume of the directions of the linear joints at these rotary angles: 1 if they are square, 0 in one plane.
/// Rotary joints between linear ones change it.
[[nodiscard]] double linear_spread(const Machine& machine, const RotaryAngles& angles);
/// Below this spread the values of the linear joints are not determined: the digits of a file move them more than 100 times
/// as far. It is the sine of 0.6 degrees.
inline constexpr double kMinLinearSpread = 0.01;

}  // namespace gouge
