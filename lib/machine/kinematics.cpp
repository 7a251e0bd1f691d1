#include "lib/machine/kinematics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lib/base/tolerance.h"
#include "lib/path/path_info.h"

namespace gouge {
namespace {

Eigen::Matrix3d turned(const Vec3& direction, double angle) {
  return Eigen::AngleAxisd(angle, direction).toRotationMatrix();
}

// Nearer to the direction of the first joint than this the tool axis is at a pole, rad.
constexpr double kPole = Tolerance::kConstruction;

/// The rigid transform of the chain with the linear joints at `linear`, applied to the tip.
Vec3 tip_of(const Machine& machine, const JointValues& joints, double tool_length_mm) {
  Vec3 at = machine.rest.point(Vec3(0, 0, -tool_length_mm));
  for (std::size_t k = machine.joints.size(); k-- > 0;) {
    const Joint& joint = machine.joints[k];
    if (joint.type == JointType::linear)
      at += joints[k] * joint.direction;
    else
      at = joint.point + turned(joint.direction, joints[k]) * (at - joint.point);
  }
  return at;
}

}  // namespace

Eigen::Matrix3d tool_axes(const Machine& machine, const RotaryAngles& angles) {
  return turned(machine.joints[machine.rotary[0]].direction, angles[0]) *
         turned(machine.joints[machine.rotary[1]].direction, angles[1]) * machine.rest.rotation;
}

// With u and w the directions of the joints, from the part: a = R(u, alpha) b, b = R(w, beta) z. Then b runs on a cone
// about w. In the spherical triangle of u, w and b the sides are known. The half-angle formula gives the angle at w
// without loss of digits at either end. Then alpha turns b to a about u.
RotarySolutions rotary_angles(const Machine& machine, const Vec3& axis) {
  const Vec3 &u = machine.joints[machine.rotary[0]].direction, &w = machine.joints[machine.rotary[1]].direction;
  const Vec3 z = machine.rest.rotation.col(2);
  RotarySolutions solutions;
  const double theta = angle_between_rad(u, axis), gamma = angle_between_rad(w, z), delta = angle_between_rad(w, u);
  if (std::sin(gamma) < Tolerance::kNoSide) return solutions;  // the second joint turns the tool about its own axis
  const double sine2 = std::sin(0.5 * (theta + gamma - delta)) * std::sin(0.5 * (theta - gamma + delta));
  const double cosine2 = std::sin(0.5 * (gamma + delta + theta)) * std::sin(0.5 * (gamma + delta - theta));
  if (sine2 < -Tolerance::kSameDirection || cosine2 < -Tolerance::kSameDirection) return solutions;
  const double half = 2 * std::atan2(std::sqrt(std::max(0.0, sine2)), std::sqrt(std::max(0.0, cosine2)));
  const double middle = std::atan2(u.dot(w.cross(z)), u.dot(z) - w.dot(z) * u.dot(w));
  for (const double beta : {middle + half, middle - half}) {
    const Vec3 b = turned(w, beta) * z;
    const Vec3 from = b - u.dot(b) * u, to = axis - u.dot(axis) * u;
    const bool is_pole = from.norm() < kPole || to.norm() < kPole;
    const double alpha = is_pole ? 0 : std::atan2(u.dot(from.cross(to)), from.dot(to));
    solutions.is_pole = solutions.is_pole || is_pole;
    solutions.all.push_back({alpha, std::remainder(beta, 2 * std::numbers::pi)});
    if (!(half > 0)) break;
  }
  return solutions;
}

Pose forward(const Machine& machine, const JointValues& joints, double tool_length_mm) {
  const RotaryAngles angles = {joints[machine.rotary[0]], joints[machine.rotary[1]]};
  return {tip_of(machine, joints, tool_length_mm), tool_axes(machine, angles).col(2)};
}

JointValues inverse(const Machine& machine, const Vec3& tip, const RotaryAngles& angles, double tool_length_mm) {
  JointValues joints(machine.joints.size(), 0);
  joints[machine.rotary[0]] = angles[0];
  joints[machine.rotary[1]] = angles[1];
  // The tip is affine in the linear joints.
  const Vec3 origin = tip_of(machine, joints, tool_length_mm);
  Eigen::Matrix3d slopes;
  for (int k = 0; k < 3; ++k) {
    JointValues one = joints;
    one[machine.linear[static_cast<std::size_t>(k)]] = 1;
    slopes.col(k) = tip_of(machine, one, tool_length_mm) - origin;
  }
  const Vec3 linear = slopes.partialPivLu().solve(tip - origin);
  for (int k = 0; k < 3; ++k) joints[machine.linear[static_cast<std::size_t>(k)]] = linear[k];
  return joints;
}

double linear_spread(const Machine& machine, const RotaryAngles& angles) {
  Eigen::Matrix3d carried = Eigen::Matrix3d::Identity(), directions;
  std::size_t rotary = 0;
  Eigen::Index linear = 0;
  for (const Joint& joint : machine.joints) {
    if (is_rotary(joint))
      carried = carried * turned(joint.direction, angles[rotary++]);
    else
      directions.col(linear++) = carried * joint.direction;
  }
  return std::abs(directions.determinant());
}

}  // namespace gouge
