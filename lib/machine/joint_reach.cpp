#include "lib/machine/joint_reach.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "lib/path/path_info.h"

namespace gouge {
namespace {

constexpr double kDigit_mm = 2e-3, kDigit_rad = 2e-6;  // digits of positions and of axes in files, with their rounding
constexpr double kSameAxis_rad = 1e-6;
constexpr std::array kShares = {0.05, 0.25, 0.5, 0.75, 1.0};  // of the way from the programmed axis, for continuity

/// Returns the turns of both rotary joints by which digits of a tool axis move them. Near a pole the first one turns far.
RotaryAngles digits_at(const Machine& machine, const Vec3& axis) {
  const double off_pole_rad = angle_between_rad(machine.joints[machine.rotary[0]].direction, axis);
  return {kDigit_rad / std::max(std::sin(off_pole_rad), kSameAxis_rad), kDigit_rad};
}

Machine without_limits(Machine machine) {
  for (const std::size_t k : machine.rotary) machine.joints[k].is_continuous = true;
  return machine;
}

/// Returns the machine with its linear limits a digit closer.
Machine with_margin(Machine machine) {
  for (const std::size_t k : machine.linear) {
    Joint& joint = machine.joints[k];
    if (joint.min) *joint.min += kDigit_mm;
    if (joint.max) *joint.max -= kDigit_mm;
  }
  return machine;
}

}  // namespace

JointReach::JointReach(Machine machine, const Toolpath& path, std::optional<double> tool_length_mm)
    : machine_(std::move(machine)),
      unlimited_(without_limits(machine_)),
      path_(path),
      tool_length_mm_(tool_length_mm),
      linear_(with_margin(machine_)) {}

bool JointReach::can_reach(std::size_t move, const Vec3& programmed, const Pose& pose) const {
  return !find_problem(move, programmed, pose);
}

std::string JointReach::why_not(std::size_t move, const Vec3& programmed, const Pose& pose) const {
  const auto problem = find_problem(move, programmed, pose);
  return problem ? problem_text(machine_, *problem) : std::string();
}

/// Returns the angles of the path at an instant of a move. Where none were chosen, any nearest ones serve.
RotaryAngles JointReach::angles_of(std::size_t move, const Vec3& programmed) const {
  RotaryAngles end{};
  if (path_.joints != nullptr && path_.joints->end[move]) end = *path_.joints->end[move];
  if (angle_between_rad(tool_axes(machine_, end).col(2), programmed) < kSameAxis_rad) return end;
  return angles_near(machine_, rotary_angles(machine_, programmed), end, false).best.value_or(end);
}

/// Takes the angles of an axis beside a pole. There the first joint may have to turn far, to any side.
std::optional<JointProblem> JointReach::leave_pole(std::size_t move, const Vec3& axis, RotaryAngles& angles) const {
  const RotarySolutions solutions = rotary_angles(machine_, axis);
  const NearAngles found = angles_near(machine_, solutions, angles, false);
  if (!found.best) return exceeded_limit(machine_, solutions, angles, move);
  const auto joint = undecided_joint(machine_, found, angles, digits_at(machine_, axis)[0]);
  if (joint) {
    const double turn_rad = (*found.best)[*joint] - angles[*joint];
    return JointProblem{JointProblem::Kind::undecided, move, machine_.rotary[*joint], turn_rad, 0};
  }
  angles = *found.best;
  return std::nullopt;
}

std::optional<JointProblem> JointReach::find_problem(std::size_t move, const Vec3& programmed, const Pose& pose) const {
  RotaryAngles angles = angles_of(move, programmed);
  const bool is_pole = rotary_angles(machine_, programmed).is_pole;
  for (const double share : kShares) {
    const Vec3 axis = share < 1 ? ((1 - share) * programmed + share * pose.axis).normalized() : pose.axis;
    const bool is_first = share <= kShares.front();
    if (is_pole && is_first) {
      if (auto problem = leave_pole(move, axis, angles)) return problem;
      continue;
    }
    const auto next = angles_near(unlimited_, rotary_angles(unlimited_, axis), angles, false).best;
    if (!next) return JointProblem{JointProblem::Kind::unreachable, move, machine_.rotary[1], 0, 0};
    angles = *next;
  }
  if (auto problem = find_rotary_problem(move, pose.axis, angles)) return problem;
  return find_linear_problem(move, pose.tip, angles);
}

std::optional<JointProblem> JointReach::find_rotary_problem(std::size_t move, const Vec3& axis,
                                                            const RotaryAngles& angles) const {
  const RotaryAngles digits = digits_at(machine_, axis);
  for (std::size_t k = 0; k < 2; ++k) {
    const Joint& joint = machine_.joints[machine_.rotary[k]];
    if (joint.is_continuous) continue;
    if (joint.min && angles[k] < *joint.min + digits[k])
      return JointProblem{JointProblem::Kind::limit, move, machine_.rotary[k], angles[k], *joint.min};
    if (joint.max && angles[k] > *joint.max - digits[k])
      return JointProblem{JointProblem::Kind::limit, move, machine_.rotary[k], angles[k], *joint.max};
  }
  return std::nullopt;
}

std::optional<JointProblem> JointReach::find_linear_problem(std::size_t move, const Vec3& tip,
                                                            const RotaryAngles& angles) const {
  if (!linear_.is_any()) return std::nullopt;
  LinearLimits limits;
  linear_.examine(move, tip, angles, gauge_length_of_move(path_, move, tool_length_mm_), limits);
  if (limits.problems.empty()) return std::nullopt;
  JointProblem problem = limits.problems.front();
  if (problem.kind == JointProblem::Kind::in_plane) return problem;
  const Joint& joint = machine_.joints[problem.joint];
  problem.limit = joint.max && problem.value > *joint.max - 2 * kDigit_mm ? *joint.max : *joint.min;
  return problem;
}

}  // namespace gouge
