#include "lib/machine/joint_path.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "lib/base/tolerance.h"
#include "lib/machine/joint_plan.h"
#include "lib/path/path_info.h"

namespace gouge {
namespace {

// Turns of a joint are equally large: components of axes in files end at 1e-6 or 1e-7.
constexpr double kSameTurn_rad = 1e-6;

using Kind = JointProblem::Kind;

/// Returns whether both solutions of every tool axis turn the axis alike: (alpha, beta) and (alpha + 180, -beta) degrees.
bool is_square(const Machine& machine) {
  const Vec3 &u = machine.joints[machine.rotary[0]].direction, &w = machine.joints[machine.rotary[1]].direction;
  const Vec3 z = machine.rest.rotation.col(2);
  return std::abs(u.dot(w)) < Tolerance::kSameDirection && u.cross(z).norm() < Tolerance::kSameDirection;
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
  [[nodiscard]] const Joint& joint(std::size_t k) const { return machine_.joints[machine_.rotary[k]]; }

  [[nodiscard]] double cost(const RotaryAngles& angles, const RotaryAngles& from) const {
    double sum = 0;
    for (std::size_t k = 0; k < 2; ++k) {
      sum += std::abs(angles[k] - from[k]);
      // Without angles before the preferred sign decides, and only then.
      if (!last_ && joint(k).preference * angles[k] < 0) sum += kWholeTurn_rad;
    }
    return sum;
  }

  /// The nearest angles of a position within the limits, and those of the other solution.
  struct Candidates {
    std::optional<RotaryAngles> best, other;
  };

  [[nodiscard]] Candidates candidates(const RotarySolutions& solutions, const RotaryAngles& from) const {
    Candidates found;
    for (const RotaryAngles& solution : solutions.all) {
      RotaryAngles angles = solution;
      if (solutions.is_pole) angles[0] = from[0];
      bool is_within = true;
      for (std::size_t k = 0; k < 2; ++k) {
        const std::optional<double> turned = turn_within_limits(joint(k), angles[k], from[k]);
        is_within = is_within && turned;
        if (turned) angles[k] = *turned;
      }
      if (!is_within) continue;
      if (!found.best || cost(angles, from) < cost(*found.best, from))
        std::swap(found.best, found.other), found.best = angles;
      else
        found.other = angles;
    }
    return found;
  }

  std::optional<RotaryAngles> nearest(const Vec3& axis, std::size_t move) {
    const RotarySolutions solutions = rotary_angles(machine_, axis);
    if (solutions.all.empty()) {
      choice_.problems.push_back({Kind::unreachable, move, machine_.rotary[1], 0, 0});
      return std::nullopt;
    }
    if (branches_) return follow_branches(solutions, move);
    const RotaryAngles from = last_.value_or(RotaryAngles{0, 0});
    auto [best, other] = candidates(solutions, from);
    if (!best) note_limit(solutions.all, from, move);
    if (best && plan_ != nullptr && (*plan_)[move] && !is_same(*best, *(*plan_)[move])) {
      other = best;
      best = *(*plan_)[move];
    }
    if (best && last_ && toolpath_.moves[move].has_start) {
      if (const auto joint = undecided_joint(*best, other, from)) {
        note_undecided(move, *joint, (*best)[*joint] - from[*joint]);
        if (is_branch_needed_ && other && !is_same_turned(*best, *other)) branches_ = {*best, *other};
        return std::nullopt;
      }
    }
    return best;
  }

  /// Follows both solutions from a position at which they were equally near, until they lead to the same angles.
  std::optional<RotaryAngles> follow_branches(const RotarySolutions& solutions, std::size_t move) {
    const auto first = candidates(solutions, (*branches_)[0]).best,
               second = candidates(solutions, (*branches_)[1]).best;
    if (!first || !second) {
      note_limit(solutions.all, (*branches_)[0], move);
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

  /// Returns the joint that may as well turn otherwise: half a turn either way, or to the other solution. None: the
  /// nearest turn is unique beyond rounding of the positions.
  [[nodiscard]] std::optional<std::size_t> undecided_joint(const RotaryAngles& best,
                                                           const std::optional<RotaryAngles>& other,
                                                           const RotaryAngles& from) const {
    for (std::size_t k = 0; k < 2; ++k) {
      const double by = best[k] - from[k];
      if (std::abs(std::abs(by) - std::numbers::pi) > kSameTurn_rad) continue;
      if (is_allowed(joint(k), best[k] - std::copysign(kWholeTurn_rad, by))) return k;
    }
    if (!other || std::abs(cost(*other, from) - cost(best, from)) > kSameTurn_rad) return std::nullopt;
    for (std::size_t k = 0; k < 2; ++k)
      if (std::abs((*other)[k] - best[k]) > kSameTurn_rad) return k;
    return std::nullopt;
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

  [[nodiscard]] static bool is_allowed(const Joint& of, double angle) {
    return of.is_continuous || (angle >= of.min.value_or(angle) && angle <= of.max.value_or(angle));
  }

  void note_limit(const std::vector<RotaryAngles>& solutions, const RotaryAngles& from, std::size_t move) {
    // Takes the solution whose first joint beyond its limits exceeds them least.
    JointProblem problem{Kind::limit, move, machine_.rotary[0], 0, 0};
    double least = std::numeric_limits<double>::infinity();
    for (const RotaryAngles& angles : solutions) {
      for (std::size_t k = 0; k < 2; ++k) {
        if (turn_within_limits(joint(k), angles[k], from[k])) continue;
        const double value = std::remainder(angles[k], kWholeTurn_rad);
        const double limit = value > joint(k).max.value_or(value) ? *joint(k).max : joint(k).min.value_or(value);
        if (std::abs(value - limit) < least) {
          least = std::abs(value - limit);
          problem = {Kind::limit, move, machine_.rotary[k], value, limit};
        }
        break;
      }
    }
    choice_.problems.push_back(problem);
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
