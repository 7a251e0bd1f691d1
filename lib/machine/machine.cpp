#include "lib/machine/machine.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "lib/base/tolerance.h"

namespace gouge {
namespace {

Diagnostic wrong(const std::string& found) { return make_error("machine-joints", found); }

std::optional<Diagnostic> find_wrong_joint(const Joint& joint) {
  if (!(joint.direction.stableNorm() > Tolerance::kNoDirection))
    return wrong("joint " + joint.name + " has a direction of no length; expected a direction such as [1, 0, 0]");
  const bool is_linear = joint.type == JointType::linear;
  if (is_linear && (joint.has_point || joint.is_continuous || std::abs(joint.preference) > 0))
    return wrong("joint " + joint.name + " is linear; expected no point, no preference and not continuous");
  constexpr double kMaxPlace_mm = 1e5, kMaxLimit = 1e7, kMaxRate = 1e12, kMinRate = 1e-4;
  if (!(joint.point.cwiseAbs().maxCoeff() <= kMaxPlace_mm))
    return wrong("joint " + joint.name + " has a point more than 100 m away; expected it nearer, check the units");
  for (const std::optional<double>& limit : {joint.min, joint.max})
    if (limit && !(std::abs(*limit) <= kMaxLimit))
      return wrong("joint " + joint.name + " has a limit that is too large; expected no limit, or a smaller one");
  if (joint.rate && !(*joint.rate <= kMaxRate && (*joint.rate <= 0 || *joint.rate >= kMinRate)))
    return wrong("joint " + joint.name + " has a rate that no machine has; expected its maximum speed per minute");
  if (joint.is_continuous && (joint.min || joint.max))
    return wrong("joint " + joint.name + " is continuous and has limits; expected one of both");
  if (joint.rate && !(*joint.rate > 0)) return wrong("joint " + joint.name + " has a rate of 0 or less; expected more");
  if (joint.min && joint.max && *joint.min > *joint.max)
    return wrong("joint " + joint.name + " has a min above its max; expected min <= max");
  return std::nullopt;
}

}  // namespace

const char* turn_law_name(TurnLaw law) { return kTurnLawNames[static_cast<std::size_t>(law)]; }

std::optional<TurnLaw> turn_law_called(const std::string& name) {
  for (std::size_t k = 0; k < kTurnLawNames.size(); ++k) {
    if (name == kTurnLawNames[k]) return static_cast<TurnLaw>(k);
  }
  return std::nullopt;
}

Result<Machine> make_machine(Machine machine) {
  std::vector<std::size_t> rotary, linear;
  for (std::size_t k = 0; k < machine.joints.size(); ++k) {
    Joint& joint = machine.joints[k];
    if (auto error = find_wrong_joint(joint)) return *error;
    if (std::ranges::count(machine.joints, joint.name, &Joint::name) > 1)
      return wrong("two joints have the name '" + joint.name + "'; expected a different name for each joint");
    joint.direction.stableNormalize();
    (joint.type == JointType::rotary ? rotary : linear).push_back(k);
  }
  const auto first_head = std::ranges::find(machine.joints, JointSide::head, &Joint::side);
  if (const auto table = std::find_if(first_head, machine.joints.end(),
                                      [](const Joint& joint) { return joint.side == JointSide::table; });
      table != machine.joints.end())
    return wrong("joint " + table->name + " of the table comes after joint " + first_head->name +
                 " of the head; expected the joints in the order from the part to the tool");
  if (rotary.size() != 2 || linear.size() != 3)
    return wrong(std::to_string(linear.size()) + " linear and " + std::to_string(rotary.size()) +
                 " rotary joints; expected three linear and two rotary ones");
  const Vec3 &u = machine.joints[rotary[0]].direction, &w = machine.joints[rotary[1]].direction;
  if (u.cross(w).norm() < Tolerance::kNoSide)
    return wrong("the rotary joints " + machine.joints[rotary[0]].name + " and " + machine.joints[rotary[1]].name +
                 " have parallel directions; expected two different ones");
  Eigen::Matrix3d directions;
  for (int k = 0; k < 3; ++k) directions.col(k) = machine.joints[linear[static_cast<std::size_t>(k)]].direction;
  if (std::abs(directions.determinant()) < Tolerance::kNoSide)
    return wrong("the linear joints lie in one plane; expected three independent directions");
  machine.rotary = {rotary[0], rotary[1]};
  machine.linear = {linear[0], linear[1], linear[2]};
  return machine;
}

Machine place_part(Machine machine, const RigidTransform& zero) {
  const RigidTransform to_part = zero.inverse();
  for (Joint& joint : machine.joints) {
    joint.direction = to_part.direction(joint.direction);
    if (is_rotary(joint)) joint.point = to_part.point(joint.point);
  }
  machine.rest = {to_part.rotation * machine.rest.rotation, to_part.point(machine.rest.shift)};
  machine.is_placed = true;
  return machine;
}

bool depends_on_tool_length(const Machine& machine) {
  Eigen::Matrix3d directions;
  for (int k = 0; k < 3; ++k) directions.col(k) = machine.joints[machine.linear[static_cast<std::size_t>(k)]].direction;
  const Vec3 shifts = directions.partialPivLu().solve(Vec3(machine.rest.rotation.col(2)));
  // The shifts of the linear joints before a rotary joint must run along its axis. Then it does not turn them.
  return std::ranges::any_of(machine.rotary, [&](std::size_t rotary) {
    Vec3 before = Vec3::Zero();
    for (int k = 0; k < 3; ++k)
      if (machine.linear[static_cast<std::size_t>(k)] < rotary) before += shifts[k] * directions.col(k);
    return before.cross(machine.joints[rotary].direction).norm() > Tolerance::kExactDirection;
  });
}

bool depends_on_part_zero(const Machine& machine) {
  const auto turns = [&](std::size_t rotary, std::size_t linear) {
    const Joint &joint = machine.joints[rotary], &slide = machine.joints[linear];
    const bool is_between = joint.side == JointSide::table ? linear < rotary : linear > rotary;
    return joint.side == slide.side && is_between &&
           slide.direction.cross(joint.direction).norm() > Tolerance::kExactDirection;
  };
  return std::ranges::any_of(machine.rotary, [&](std::size_t rotary) {
    return std::ranges::any_of(machine.linear, [&](std::size_t linear) { return turns(rotary, linear); });
  });
}

}  // namespace gouge
