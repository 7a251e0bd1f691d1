#include "lib/machine/linear_limits.h"

#include <algorithm>
#include <cmath>

#include "lib/base/tolerance.h"

namespace gouge {
namespace {

/// Returns the limit that a value exceeds; none: it is within the limits.
std::optional<double> exceeded_limit(const Joint& joint, double value) {
  if (joint.min && !(value >= *joint.min - Tolerance::kRounding_mm)) return joint.min;
  if (joint.max && !(value <= *joint.max + Tolerance::kRounding_mm)) return joint.max;
  return std::nullopt;
}

void note_once(std::size_t joint, std::vector<std::size_t>& joints) {
  if (std::ranges::find(joints, joint) == joints.end()) joints.push_back(joint);
}

/// Returns machines that differ from one in a fact that is not known: the points of rotary joints.
std::vector<Machine> with_other_points(const Machine& machine) {
  std::vector<Machine> others;
  for (const std::size_t k : machine.rotary) {
    if (machine.joints[k].has_point) continue;
    for (int axis = 0; axis < 3; ++axis) {
      others.push_back(machine);
      others.back().joints[k].point[axis] += 1;
    }
  }
  return others;
}

}  // namespace

LinearLimits check_linear_limits(const Machine& machine, const Toolpath& path,
                                 const std::optional<double>& tool_length_mm) {
  LinearLimits limits;
  const bool has_limits = std::ranges::any_of(
      machine.linear, [&](std::size_t k) { return machine.joints[k].min || machine.joints[k].max; });
  if (!machine.is_placed || !has_limits) return limits;
  const std::vector<Machine> others = with_other_points(machine);
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const auto& angles = path.joints->end[i];
    if (!angles) continue;
    const std::optional<double> stated_mm = gauge_length_of_move(path, i, tool_length_mm);
    const double length_mm = stated_mm.value_or(0);
    const Vec3& tip = path.moves[i].end.tip;
    const JointValues values = inverse(machine, tip, *angles, length_mm);
    std::vector<JointValues> possible;
    if (!stated_mm) possible.push_back(inverse(machine, tip, *angles, 1));
    for (const Machine& other : others) possible.push_back(inverse(other, tip, *angles, length_mm));
    const auto is_open = [&](std::size_t k) {
      return std::ranges::any_of(possible, [&](const JointValues& other) {
        return std::abs(other[k] - values[k]) > Tolerance::kSameDirection;
      });
    };
    for (const std::size_t k : machine.linear) {
      const Joint& joint = machine.joints[k];
      if (!joint.min && !joint.max) continue;
      if (is_open(k))
        note_once(k, limits.open);
      else if (const auto limit = exceeded_limit(joint, values[k]))
        limits.problems.push_back({JointProblem::Kind::limit, i, k, values[k], *limit});
    }
  }
  std::ranges::sort(limits.open);
  return limits;
}

}  // namespace gouge
