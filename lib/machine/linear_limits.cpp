#include "lib/machine/linear_limits.h"

#include <algorithm>
#include <cmath>

#include "lib/base/tolerance.h"

namespace gouge {
namespace {

/// Returns the limit that a value exceeds; none: it is within the limits.
std::optional<double> exceeded_limit(const Joint& joint, double value) {
  if (joint.min && value < *joint.min - Tolerance::kRounding_mm) return joint.min;
  if (joint.max && value > *joint.max + Tolerance::kRounding_mm) return joint.max;
  return std::nullopt;
}

void note_once(std::size_t joint, std::vector<std::size_t>& joints) {
  if (std::ranges::find(joints, joint) == joints.end()) joints.push_back(joint);
}

}  // namespace

LinearLimits check_linear_limits(const Machine& machine, const Toolpath& path,
                                 const std::optional<double>& tool_length_mm) {
  LinearLimits limits;
  const bool has_limits = std::ranges::any_of(
      machine.linear, [&](std::size_t k) { return machine.joints[k].min || machine.joints[k].max; });
  if (!machine.is_placed || !has_limits) return limits;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const auto& angles = path.joints->end[i];
    if (!angles) continue;
    const Vec3& tip = path.moves[i].end.tip;
    const JointValues values = inverse(machine, tip, *angles, tool_length_mm.value_or(0));
    const JointValues longer = tool_length_mm ? values : inverse(machine, tip, *angles, 1);
    for (const std::size_t k : machine.linear) {
      const Joint& joint = machine.joints[k];
      if (!joint.min && !joint.max) continue;
      if (std::abs(longer[k] - values[k]) > Tolerance::kExactDirection)
        note_once(k, limits.open);
      else if (const auto limit = exceeded_limit(joint, values[k]))
        limits.problems.push_back({JointProblem::Kind::limit, i, k, values[k], *limit});
    }
  }
  std::ranges::sort(limits.open);
  return limits;
}

}  // namespace gouge
