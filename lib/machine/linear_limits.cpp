#include "lib/machine/linear_limits.h"

#include <algorithm>
#include <cmath>

#include "lib/base/tolerance.h"

namespace gouge {
namespace {

/// Returns the limit that a value exceeds; none: it is within the limits.
std::optional<double> limit_exceeded_by(const Joint& joint, double value) {
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

LinearLimitTest::LinearLimitTest(const Machine& machine) : machine_(machine), others_(with_other_points(machine)) {
  is_any_ = machine.is_placed && std::ranges::any_of(machine.linear, [&](std::size_t k) {
              return machine.joints[k].min || machine.joints[k].max;
            });
}

void LinearLimitTest::examine(std::size_t move, const Vec3& tip, const RotaryAngles& angles,
                              const std::optional<double>& stated_mm, LinearLimits& limits) const {
  if (linear_spread(machine_, angles) < kMinLinearSpread) {
    limits.problems.push_back({JointProblem::Kind::in_plane, move, machine_.linear[0], 0, 0});
    return;
  }
  const double length_mm = stated_mm.value_or(0);
  const JointValues values = inverse(machine_, tip, angles, length_mm);
  std::vector<JointValues> possible;
  if (!stated_mm) possible.push_back(inverse(machine_, tip, angles, 1));
  for (const Machine& other : others_) possible.push_back(inverse(other, tip, angles, length_mm));
  const auto is_open = [&](std::size_t k) {
    return std::ranges::any_of(
        possible, [&](const JointValues& other) { return std::abs(other[k] - values[k]) > Tolerance::kSameDirection; });
  };
  for (const std::size_t k : machine_.linear) {
    const Joint& joint = machine_.joints[k];
    if (!joint.min && !joint.max) continue;
    if (is_open(k))
      note_once(k, limits.open);
    else if (const auto limit = limit_exceeded_by(joint, values[k]))
      limits.problems.push_back({JointProblem::Kind::limit, move, k, values[k], *limit});
  }
}

LinearLimits check_linear_limits(const Machine& machine, const Toolpath& path,
                                 const std::optional<double>& tool_length_mm) {
  LinearLimits limits;
  const LinearLimitTest test(machine);
  if (!test.is_any()) return limits;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const auto& angles = path.joints->end[i];
    if (angles) test.examine(i, path.moves[i].end.tip, *angles, gauge_length_of_move(path, i, tool_length_mm), limits);
  }
  std::ranges::sort(limits.open);
  return limits;
}

}  // namespace gouge
