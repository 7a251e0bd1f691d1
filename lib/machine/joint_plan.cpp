#include "lib/machine/joint_plan.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include "lib/base/tolerance.h"
#include "lib/machine/joint_path.h"
#include "lib/path/path_info.h"

namespace gouge {
namespace {

/// Cost of a plan up to a position: fewer breaks go before smaller turns.
struct PlanCost {
  std::size_t breaks = 0;
  double turn_rad = 0;

  [[nodiscard]] bool is_less(const PlanCost& other) const {
    return breaks != other.breaks ? breaks < other.breaks : turn_rad < other.turn_rad;
  }
};

/// Angles at a position, with the state before it on the best plan that leads here.
struct PlanState {
  RotaryAngles angles{};
  std::uint32_t before = 0;
};

class Planner {
 public:
  Planner(const Machine& machine, const Toolpath& toolpath) : machine_(machine), toolpath_(toolpath) {}

  std::vector<std::optional<RotaryAngles>> run() {
    plan_.resize(toolpath_.moves.size());
    for (std::size_t i = 0; i < toolpath_.moves.size(); ++i) {
      std::vector<PlanState> states;
      std::vector<PlanCost> costs;
      add_states(i, states, costs);
      if (states.empty()) {
        trace_back(i);
        continue;
      }
      layers_.push_back(std::move(states));
      costs_ = std::move(costs);
    }
    trace_back(toolpath_.moves.size());
    return std::move(plan_);
  }

 private:
  [[nodiscard]] const Joint& joint(std::size_t k) const { return machine_.joints[machine_.rotary[k]]; }

  /// Returns whether a joint has room for so many turns that a plan need not distinguish them.
  static bool is_free(const Joint& of) {
    return of.is_continuous || !of.min || !of.max || *of.max - *of.min > 2 * kTurns * kWholeTurn_rad;
  }

  /// Returns the turns of an angle to try after `from`. Where the nearest turn is within the limits, no other has fewer
  /// breaks. At the first position, and where the joint must turn back, these are all turns within kTurns of the nearest.
  [[nodiscard]] std::vector<double> turns_of(std::size_t k, double angle, double from, bool is_first) const {
    const Joint& of = joint(k);
    std::vector<double> turns;
    const auto nearest = turn_within_limits(of, angle, from);
    if (!nearest) return turns;
    turns.push_back(*nearest);
    const bool is_kept = !turns_back(*nearest - from);
    if (is_free(of) || (is_kept && !is_first)) return turns;
    for (int n = -kTurns; n <= kTurns; ++n) {
      const double turned = *nearest + n * kWholeTurn_rad;
      const bool is_within = turned >= of.min.value_or(turned) - Tolerance::kSameDirection &&
                             turned <= of.max.value_or(turned) + Tolerance::kSameDirection;
      if (n != 0 && is_within) turns.push_back(turned);
    }
    return turns;
  }

  /// Adds the angles of a position that follow those of one state before it, or of none.
  void add_from(const RotarySolutions& solutions, std::size_t move, const RotaryAngles* before, std::uint32_t index,
                const PlanCost& so_far, std::vector<PlanState>& states, std::vector<PlanCost>& costs) const {
    const RotaryAngles from = before == nullptr ? RotaryAngles{0, 0} : *before;
    for (const RotaryAngles& solution : solutions.all) {
      const double first = solutions.is_pole ? from[0] : solution[0];
      for (const double alpha : turns_of(0, first, from[0], before == nullptr)) {
        if (solutions.is_pole && std::abs(alpha - first) > Tolerance::kSameDirection) continue;
        for (const double beta : turns_of(1, solution[1], from[1], before == nullptr))
          offer({{alpha, beta}, index}, cost_of({alpha, beta}, from, before == nullptr, move, so_far), states, costs);
      }
    }
  }

  [[nodiscard]] PlanCost cost_of(const RotaryAngles& angles, const RotaryAngles& from, bool is_first, std::size_t move,
                                 PlanCost cost) const {
    for (std::size_t k = 0; k < 2; ++k) {
      cost.turn_rad += std::abs(angles[k] - from[k]);
      if (is_first && joint(k).preference * angles[k] < 0) cost.turn_rad += kWholeTurn_rad;
    }
    if (!is_first && toolpath_.moves[move].has_start && breaks_off(machine_, from, angles)) ++cost.breaks;
    return cost;
  }

  /// Keeps the cheapest way to each pair of angles.
  void offer(const PlanState& state, const PlanCost& cost, std::vector<PlanState>& states,
             std::vector<PlanCost>& costs) const {
    for (std::size_t n = 0; n < states.size(); ++n) {
      const auto differs = [&](std::size_t k) {
        const double by = states[n].angles[k] - state.angles[k];
        return std::abs(is_free(joint(k)) ? std::remainder(by, kWholeTurn_rad) : by) > Tolerance::kSameDirection;
      };
      if (differs(0) || differs(1)) continue;
      if (cost.is_less(costs[n])) {
        states[n] = state;
        costs[n] = cost;
      }
      return;
    }
    states.push_back(state);
    costs.push_back(cost);
  }

  void add_states(std::size_t move, std::vector<PlanState>& states, std::vector<PlanCost>& costs) const {
    const RotarySolutions solutions = rotary_angles(machine_, toolpath_.moves[move].end.axis);
    if (layers_.empty()) return add_from(solutions, move, nullptr, 0, {}, states, costs);
    const std::vector<PlanState>& last = layers_.back();
    for (std::size_t n = 0; n < last.size(); ++n)
      add_from(solutions, move, &last[n].angles, static_cast<std::uint32_t>(n), costs_[n], states, costs);
  }

  /// Stores the cheapest plan of the positions before `end` that are planned but not stored.
  void trace_back(std::size_t end) {
    if (layers_.empty()) return;
    const auto cheapest = std::ranges::min_element(costs_, [](const auto& a, const auto& b) { return a.is_less(b); });
    auto at = static_cast<std::uint32_t>(cheapest - costs_.begin());
    for (std::size_t n = layers_.size(); n-- > 0;) {
      plan_[--end] = layers_[n][at].angles;
      at = layers_[n][at].before;
    }
    layers_.clear();
    costs_.clear();
  }

  static constexpr int kTurns = 4;  // beyond the nearest

  const Machine& machine_;
  const Toolpath& toolpath_;
  std::vector<std::vector<PlanState>> layers_;  // of consecutive positions
  std::vector<PlanCost> costs_;                 // of the last layer
  std::vector<std::optional<RotaryAngles>> plan_;
};

}  // namespace

bool turns_back(double joint_rad) { return std::abs(joint_rad) > std::numbers::pi + Tolerance::kSameDirection; }

bool flips(double joint_rad, double axis_rad) {
  constexpr double kFlip_rad = std::numbers::pi / 4, kFlipTimes = 4;
  return std::abs(joint_rad) > kFlip_rad && std::abs(joint_rad) > kFlipTimes * axis_rad;
}

bool breaks_off(const Machine& machine, const RotaryAngles& from, const RotaryAngles& to) {
  const double turn = angle_between_rad(tool_axes(machine, from).col(2), tool_axes(machine, to).col(2));
  const auto breaks = [&](std::size_t k) { return turns_back(to[k] - from[k]) || flips(to[k] - from[k], turn); };
  return breaks(0) || breaks(1);
}

std::vector<std::optional<RotaryAngles>> plan_joints(const Machine& machine, const Toolpath& toolpath) {
  return Planner(machine, toolpath).run();
}

}  // namespace gouge
