#include "lib/machine/law_facts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "lib/base/tolerance.h"
#include "lib/base/units.h"
#include "lib/machine/joint_path.h"
#include "lib/machine/kinematics.h"

namespace gouge {
namespace {

using Doubt = MachineDoubt::Kind;

bool has_limits(const Joint& joint) { return joint.is_continuous || joint.min || joint.max; }

/// Returns whether a joint has a doubt that concerns it alone.
bool has_doubt(const Machine& machine, std::size_t k, Doubt kind) {
  const Joint& joint = machine.joints[k];
  switch (kind) {
    case Doubt::no_limits:
      return is_rotary(joint) && !has_limits(joint);
    case Doubt::no_linear_limits:
      return !is_rotary(joint) && !has_limits(joint);
    case Doubt::no_rate:
      return !joint.rate;
    case Doubt::fixed:
      return joint.min && joint.max && !(*joint.max > *joint.min);
    case Doubt::idle:
      return k == machine.rotary[1] && joint.direction.cross(machine.rest.rotation.col(2)).norm() < Tolerance::kNoSide;
    case Doubt::not_at_zero:
      return joint.min.value_or(0) > 0 || joint.max.value_or(0) < 0;
    case Doubt::preference:
      return (joint.preference > 0 && joint.max && *joint.max <= 0) ||
             (joint.preference < 0 && joint.min && *joint.min >= 0);
  }
  return false;
}

/// Returns whether the machine reaches a tool axis within the limits of its rotary joints.
bool is_reached(const Machine& machine, const Vec3& axis) {
  const RotarySolutions solutions = rotary_angles(machine, axis);
  return std::ranges::any_of(solutions.all, [&](const RotaryAngles& angles) {
    for (std::size_t k = 0; k < 2; ++k) {
      const bool is_free = solutions.is_pole && k == 0;
      if (!is_free && !turn_within_limits(machine.joints[machine.rotary[k]], angles[k], angles[k])) return false;
    }
    return true;
  });
}

}  // namespace

bool runs_joints(TurnLaw law) { return law == TurnLaw::joint || law == TurnLaw::independent; }

std::vector<MissingFact> missing_facts(const Machine& machine, TurnLaw law, bool has_tool_length) {
  std::vector<MissingFact> missing;
  if (!runs_joints(law)) return missing;
  using Fact = MissingFact::Kind;
  for (const std::size_t k : machine.rotary)
    if (!machine.joints[k].has_point) missing.push_back({Fact::point, k});
  if (!has_tool_length && depends_on_tool_length(machine)) missing.push_back({Fact::tool_length, 0});
  if (!machine.is_placed && depends_on_part_zero(machine)) missing.push_back({Fact::part_zero, 0});
  if (law != TurnLaw::independent) return missing;
  for (std::size_t k = 0; k < machine.joints.size(); ++k)
    if (!machine.joints[k].rate) missing.push_back({Fact::rate, k});
  return missing;
}

std::vector<MachineDoubt> find_doubts(const Machine& machine) {
  std::vector<MachineDoubt> doubts;
  for (const Doubt kind : {Doubt::no_limits, Doubt::no_linear_limits, Doubt::no_rate, Doubt::fixed, Doubt::idle,
                           Doubt::not_at_zero, Doubt::preference}) {
    MachineDoubt doubt{kind, {}};
    for (std::size_t k = 0; k < machine.joints.size(); ++k)
      if (has_doubt(machine, k, kind)) doubt.joints.push_back(k);
    if (!doubt.joints.empty()) doubts.push_back(std::move(doubt));
  }
  return doubts;
}

AxisReach measure_reach(const Machine& machine) {
  AxisReach reach{std::numeric_limits<double>::infinity(), 0, -1};
  bool is_whole = true;
  for (int tilt = 0; tilt <= 180; ++tilt) {
    const double theta = tilt * kDegree_rad;
    const int around = tilt == 0 || tilt == 180 ? 1 : 360;
    int reached = 0;
    for (int turn = 0; turn < around; ++turn) {
      const double phi = turn * kDegree_rad;
      const Vec3 axis(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
      if (is_reached(machine, machine.rest.direction(axis))) ++reached;
    }
    if (reached > 0) {
      reach.least = std::min(reach.least, theta);
      reach.most = theta;
    }
    is_whole = is_whole && reached == around;
    if (is_whole) reach.whole = theta;
  }
  return reach;
}

}  // namespace gouge
