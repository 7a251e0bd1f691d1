#include "lib/machine/joint_path.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "lib/base/number_text.h"
#include "lib/base/tolerance.h"
#include "lib/base/units.h"
#include "lib/machine/joint_plan.h"
#include "lib/path/path_info.h"

namespace gouge {
namespace {

// Turns of a joint are equally large: components of axes in files end at 1e-6 or 1e-7.
constexpr double kSameTurn_rad = 1e-6;

using Kind = JointProblem::Kind;

const Joint& rotary_joint(const Machine& machine, std::size_t k) { return machine.joints[machine.rotary[k]]; }

/// Returns whether both solutions of every tool axis turn the axis alike: (alpha, beta) and (alpha + 180, -beta) degrees.
bool is_square(const Machine& machine) {
  const Vec3 &u = machine.joints[machine.rotary[0]].direction, &w = machine.joints[machine.rotary[1]].direction;
  const Vec3 z = machine.rest.rotation.col(2);
  return std::abs(u.dot(w)) < Tolerance::kSameDirection && u.cross(z).norm() < Tolerance::kSameDirection;
}

double turn_rad(const Machine& machine, const RotaryAngles& angles, const RotaryAngles& from, bool is_first) {
  double sum = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    sum += std::abs(angles[k] - from[k]);
    // Without angles before the preferred sign decides, and only then.
    if (is_first && rotary_joint(machine, k).preference * angles[k] < 0) sum += kWholeTurn_rad;
  }
  return sum;
}

bool is_allowed(const Joint& of, double angle) {
  return of.is_continuous || (angle >= of.min.value_or(angle) && angle <= of.max.value_or(angle));
}

class Chooser {
 public:
  Chooser(const Machine& machine, const Toolpath& toolpath, bool is_branch_needed)
      : machine_(machine), toolpath_(toolpath), is_branch_needed_(is_branch_needed) {}
  /// Follows a plan in place of the nearest angles.
  Chooser(const Machine& machine, const Toolpath& toolpath, bool is_branch_needed,
          const std::vector<std::optional<RotaryAngles>>& plan)
      : machine_(machine), toolpath_(toolpath), is_branch_needed_(is_branch_needed), plan_(&plan) {}

  JointChoice run() {
    JointPath& path = choice_.path;
    for (std::size_t i = 0; i < toolpath_.moves.size(); ++i) {
      const Move& move = toolpath_.moves[i];
      path.start.push_back(move.has_start ? last_ : std::nullopt);
      last_ = nearest(move.end.axis, i);
      path.end.push_back(last_);
      if (path.start.back() && last_) find_flip(i, *path.start.back(), *last_);
    }
    return std::move(choice_);
  }

 private:
  std::optional<RotaryAngles> nearest(const Vec3& axis, std::size_t move) {
    const RotarySolutions solutions = rotary_angles(machine_, axis);
    if (solutions.all.empty()) {
      choice_.problems.push_back({Kind::unreachable, move, machine_.rotary[1], 0, 0});
      return std::nullopt;
    }
    if (branches_) return follow_branches(solutions, move);
    const RotaryAngles from = last_.value_or(RotaryAngles{0, 0});
    auto [best, other] = angles_near(machine_, solutions, from, !last_);
    if (!best) choice_.problems.push_back(exceeded_limit(machine_, solutions, from, move));
    if (best && plan_ != nullptr && (*plan_)[move] && !is_same(*best, *(*plan_)[move])) {
      other = best;
      best = *(*plan_)[move];
    }
    if (best && last_ && toolpath_.moves[move].has_start) {
      if (const auto joint = undecided_joint(machine_, {best, other}, from, kSameTurn_rad)) {
        note_undecided(move, *joint, (*best)[*joint] - from[*joint]);
        if (is_branch_needed_ && other && !is_same_turned(*best, *other)) branches_ = {*best, *other};
        return std::nullopt;
      }
    }
    return best;
  }

  /// Follows both solutions from a position at which they were equally near, until they lead to the same angles.
  std::optional<RotaryAngles> follow_branches(const RotarySolutions& solutions, std::size_t move) {
    const auto first = angles_near(machine_, solutions, (*branches_)[0], !last_).best,
               second = angles_near(machine_, solutions, (*branches_)[1], !last_).best;
    if (!first || !second) {
      choice_.problems.push_back(exceeded_limit(machine_, solutions, (*branches_)[0], move));
      return std::nullopt;
    }
    if (is_same_turned(*first, *second)) {
      branches_.reset();
      return first;
    }
    note_undecided(move, 0, (*first)[0] - (*branches_)[0][0]);
    branches_ = {*first, *second};
    return std::nullopt;
  }

  void note_undecided(std::size_t move, std::size_t joint, double turn_rad) {
    ++choice_.breaks;
    choice_.problems.push_back({Kind::undecided, move, machine_.rotary[joint], turn_rad, 0});
  }

  /// Returns whether angles are the same but for whole turns.
  static bool is_same_turned(const RotaryAngles& a, const RotaryAngles& b) {
    return std::abs(std::remainder(a[0] - b[0], kWholeTurn_rad)) +
               std::abs(std::remainder(a[1] - b[1], kWholeTurn_rad)) <=
           kSameTurn_rad;
  }

  static bool is_same(const RotaryAngles& a, const RotaryAngles& b) {
    return std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) <= Tolerance::kSameDirection;
  }

  void find_flip(std::size_t move, const RotaryAngles& from, const RotaryAngles& to) {
    const Vec3 before = tool_axes(machine_, from).col(2), after = tool_axes(machine_, to).col(2);
    const double turn = angle_between_rad(before, after);
    bool is_break = false;
    for (std::size_t k = 0; k < 2; ++k) {
      const double by = to[k] - from[k];
      const bool is_unwound = turns_back(by);
      if (!is_unwound && !flips(by, turn)) continue;
      is_break = true;
      choice_.problems.push_back({is_unwound ? Kind::unwind : Kind::flip, move, machine_.rotary[k], by, turn});
    }
    if (is_break) ++choice_.breaks;
  }

  const Machine& machine_;
  const Toolpath& toolpath_;
  bool is_branch_needed_;
  const std::vector<std::optional<RotaryAngles>>* plan_ = nullptr;
  std::optional<std::array<RotaryAngles, 2>> branches_;  // angles of both solutions while they are equally near
  std::optional<RotaryAngles> last_;
  JointChoice choice_;
};

}  // namespace

std::optional<double> turn_within_limits(const Joint& joint, double angle, double to) {
  const double nearest = to + std::remainder(angle - to, kWholeTurn_rad);
  if (joint.is_continuous) return nearest;
  const double low = joint.min.value_or(-std::numeric_limits<double>::infinity()) - Tolerance::kSameDirection;
  const double high = joint.max.value_or(std::numeric_limits<double>::infinity()) + Tolerance::kSameDirection;
  double best = nearest;
  if (best > high) best -= kWholeTurn_rad * std::ceil((best - high) / kWholeTurn_rad);
  if (best < low) best += kWholeTurn_rad * std::ceil((low - best) / kWholeTurn_rad);
  return best > high ? std::nullopt : std::optional(best);
}

NearAngles angles_near(const Machine& machine, const RotarySolutions& solutions, const RotaryAngles& from,
                       bool is_first) {
  NearAngles found;
  for (const RotaryAngles& solution : solutions.all) {
    RotaryAngles angles = solution;
    if (solutions.is_pole) angles[0] = from[0];
    bool is_within = true;
    for (std::size_t k = 0; k < 2; ++k) {
      const std::optional<double> turned = turn_within_limits(rotary_joint(machine, k), angles[k], from[k]);
      is_within = is_within && turned;
      if (turned) angles[k] = *turned;
    }
    if (!is_within) continue;
    if (!found.best || turn_rad(machine, angles, from, is_first) < turn_rad(machine, *found.best, from, is_first))
      std::swap(found.best, found.other), found.best = angles;
    else
      found.other = angles;
  }
  return found;
}

std::optional<std::size_t> undecided_joint(const Machine& machine, const NearAngles& near, const RotaryAngles& from,
                                           double same_rad) {
  const auto& [best, other] = near;
  for (std::size_t k = 0; k < 2; ++k) {
    const double by = (*best)[k] - from[k];
    if (std::abs(std::abs(by) - std::numbers::pi) > same_rad) continue;
    if (is_allowed(rotary_joint(machine, k), (*best)[k] - std::copysign(kWholeTurn_rad, by))) return k;
  }
  if (!other) return std::nullopt;
  if (std::abs(turn_rad(machine, *other, from, false) - turn_rad(machine, *best, from, false)) > same_rad)
    return std::nullopt;
  for (std::size_t k = 0; k < 2; ++k)
    if (std::abs((*other)[k] - (*best)[k]) > same_rad) return k;
  return std::nullopt;
}

JointProblem exceeded_limit(const Machine& machine, const RotarySolutions& solutions, const RotaryAngles& from,
                            std::size_t move) {
  // Takes the solution whose first joint beyond its limits exceeds them least.
  JointProblem problem{Kind::limit, move, machine.rotary[0], 0, 0};
  double least = std::numeric_limits<double>::infinity();
  for (const RotaryAngles& angles : solutions.all) {
    for (std::size_t k = 0; k < 2; ++k) {
      const Joint& joint = rotary_joint(machine, k);
      if (turn_within_limits(joint, angles[k], from[k])) continue;
      const double value = std::remainder(angles[k], kWholeTurn_rad);
      const double limit = value > joint.max.value_or(value) ? *joint.max : joint.min.value_or(value);
      if (std::abs(value - limit) < least) {
        least = std::abs(value - limit);
        problem = {Kind::limit, move, machine.rotary[k], value, limit};
      }
      break;
    }
  }
  return problem;
}

std::string joint_value_text(const Joint& joint, double value, int decimals) {
  return is_rotary(joint) ? display_text(value / kDegree_rad, decimals) + " degrees"
                          : display_text(value, decimals) + " mm";
}

// Returns the decimals with which two values of a joint differ, three at least.
static int decimals_apart(const Joint& joint, double a, double b) {
  constexpr int kFewest = 3, kMost = 9;
  int decimals = kFewest;
  while (decimals < kMost && joint_value_text(joint, a, decimals) == joint_value_text(joint, b, decimals)) ++decimals;
  return decimals;
}

std::string problem_text(const Machine& machine, const JointProblem& problem) {
  const Joint& joint = machine.joints[problem.joint];
  if (problem.kind == Kind::unreachable) return "no position of the rotary joints gives this tool axis";
  if (problem.kind == Kind::in_plane)
    return "the linear joints lie nearly in one plane there, so that their values are not determined";
  if (problem.kind == Kind::undecided)
    return "joint " + joint.name + " may turn by " + joint_value_text(joint, problem.value) +
           " or another way that is equally near; add a position between, or set limits";
  const int decimals = decimals_apart(joint, problem.value, problem.limit);
  return "joint " + joint.name + " would be at " + joint_value_text(joint, problem.value, decimals) +
         "; its limit is " + joint_value_text(joint, problem.limit);
}

JointChoice choose_joints(const Machine& machine, const Toolpath& toolpath, bool is_turn_needed) {
  const bool is_branch_needed = is_turn_needed || !is_square(machine);
  JointChoice nearest = Chooser(machine, toolpath, is_branch_needed).run();
  if (nearest.breaks == 0) return nearest;
  const std::vector<std::optional<RotaryAngles>> plan = plan_joints(machine, toolpath);
  JointChoice planned = Chooser(machine, toolpath, is_branch_needed, plan).run();
  return planned.breaks < nearest.breaks ? planned : nearest;
}

JointChoice check_joints(const Machine& machine, const Toolpath& toolpath, const JointPath& stated) {
  JointChoice choice{stated, {}, 0};
  for (std::size_t i = 0; i < toolpath.moves.size(); ++i) {
    if (!stated.end[i]) continue;
    for (std::size_t k = 0; k < 2; ++k) {
      const Joint& joint = machine.joints[machine.rotary[k]];
      const double angle = (*stated.end[i])[k];
      if (joint.is_continuous) continue;
      const double low = joint.min.value_or(angle), high = joint.max.value_or(angle);
      if (angle >= low - Tolerance::kSameDirection && angle <= high + Tolerance::kSameDirection) continue;
      choice.problems.push_back({Kind::limit, i, machine.rotary[k], angle, angle < low ? low : high});
      break;
    }
  }
  return choice;
}

}  // namespace gouge
