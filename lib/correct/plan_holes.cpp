#include "lib/correct/plan_holes.h"

#include <algorithm>
#include <optional>

#include "lib/contact/aims.h"
#include "lib/correct/free_pose.h"

namespace gouge {
namespace {

constexpr double kLeastStep_mm = 5e-4;
constexpr int kSteps = 40;

class HolePlanner {
 public:
  HolePlanner(const Toolpath& path, const CheckResult& result, const std::vector<const ToolVariants*>& tools,
              const MotionChecker& checker, const CorrectOptions& correct)
      : path_(path), result_(result), tools_(tools), checker_(checker), correct_(correct) {}

  [[nodiscard]] std::optional<HolePlan> plan(std::size_t first) const {
    HolePlan plan;
    plan.first = first;
    plan.last = end_of_hole(path_, first);
    std::vector<std::size_t> gouging;
    for (std::size_t i = first; i < plan.last; ++i) {
      const MoveVerdict& verdict = result_.verdicts[i];
      if (verdict.state == MoveState::buried || verdict.state == MoveState::not_checked) return std::nullopt;
      if (verdict.state != MoveState::gouge) continue;
      gouging.push_back(i);
      plan.depth_before_mm = std::max(plan.depth_before_mm, verdict.depth_mm);
    }
    const Vec3 axis = path_.moves[first].end.axis;
    double lift = 0;
    for (int step = 0; step < kSteps && !gouging.empty(); ++step) {
      lift += std::max(kLeastStep_mm, excess(gouging, lift * axis));
      if (lift > correct_.max_shift_mm) return std::nullopt;
      plan.shift_mm = lift * axis;
      if (!is_clean(gouging, plan.shift_mm)) continue;
      if (!keeps_law(gouging, plan.shift_mm)) return std::nullopt;
      for (const std::size_t i : gouging) plan.depth_after_mm = std::max(plan.depth_after_mm, depth(i, plan.shift_mm));
      return plan;
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] Motion shifted(std::size_t i, const Vec3& by) const {
    const Pose &start = path_.start_of(i), &end = path_.moves[i].end;
    return Motion({start.tip + by, start.axis}, {end.tip + by, end.axis});
  }
  [[nodiscard]] const ToolVariants& tool_of(std::size_t i) const { return *tools_[path_.moves[i].tool]; }
  [[nodiscard]] CheckOptions within(double share) const {
    CheckOptions options = checker_.options();
    options.near_miss_mm = 0;
    options.tolerance_mm *= share;
    return options;
  }

  [[nodiscard]] double excess(const std::vector<std::size_t>& gouging, const Vec3& by) const {
    const CheckOptions options = within(kPositionAimShare);
    double most = 0;
    for (const std::size_t i : gouging) {
      const MoveVerdict verdict = checker_.check(shifted(i, by), path_.moves[i].kind, tool_of(i), options);
      const bool is_air = verdict.witness && verdict.witness->against == Against::fixture;
      const double aim = is_air ? -kAir_mm : options.tolerance_mm;
      if (verdict.state == MoveState::gouge) most = std::max(most, verdict.depth_mm - aim);
    }
    return most;
  }
  [[nodiscard]] bool is_clean(const std::vector<std::size_t>& gouging, const Vec3& by) const {
    return std::all_of(gouging.begin(), gouging.end(), [&](std::size_t i) {
      return checker_.is_clean(shifted(i, by), path_.moves[i].kind, tool_of(i), within(kMotionAimShare));
    });
  }
  [[nodiscard]] double depth(std::size_t i, const Vec3& by) const {
    return checker_.check(shifted(i, by), path_.moves[i].kind, tool_of(i), within(0)).depth_mm;
  }
  [[nodiscard]] bool keeps_law(const std::vector<std::size_t>& gouging, const Vec3& by) const {
    return std::all_of(gouging.begin(), gouging.end(), [&](std::size_t i) {
      const Pose& end = path_.moves[i].end;
      return why_not_shift(end, {end.tip + by, end.axis}, path_.moves[i].kind, tool_of(i), checker_) == nullptr;
    });
  }

  const Toolpath& path_;
  const CheckResult& result_;
  const std::vector<const ToolVariants*>& tools_;
  const MotionChecker& checker_;
  const CorrectOptions& correct_;
};

}  // namespace

std::size_t end_of_hole(const Toolpath& path, std::size_t first) {
  std::size_t last = first + 1;
  while (last < path.moves.size() && path.moves[last].kind == MoveKind::cycle &&
         path.moves[last].statement == path.moves[first].statement)
    ++last;
  return last;
}

std::vector<HolePlan> plan_holes(const Toolpath& path, const CheckResult& result,
                                 const std::vector<const ToolVariants*>& tools, const MotionChecker& checker,
                                 const CorrectOptions& correct) {
  std::vector<HolePlan> plans;
  if (correct.rewritable == nullptr || correct.rewritable->hole.empty()) return plans;
  const std::vector<bool>& can_shift = correct.rewritable->hole;
  const HolePlanner planner(path, result, tools, checker, correct);
  for (std::size_t i = 1; i < path.moves.size(); ++i) {
    if (!can_shift[i] || !path.moves[i].has_start) continue;
    // Of several positions in one statement it is not stated which moves are of which.
    const std::size_t last = end_of_hole(path, i);
    const bool is_alone = path.moves[i - 1].statement != path.moves[i].statement &&
                          std::count(can_shift.begin() + static_cast<std::ptrdiff_t>(i),
                                     can_shift.begin() + static_cast<std::ptrdiff_t>(last), true) == 1;
    if (!is_alone) continue;
    const bool is_gouging = std::any_of(result.verdicts.begin() + static_cast<std::ptrdiff_t>(i),
                                        result.verdicts.begin() + static_cast<std::ptrdiff_t>(last),
                                        [](const MoveVerdict& v) { return v.state == MoveState::gouge; });
    if (!is_gouging) continue;
    if (auto plan = planner.plan(i)) plans.push_back(*plan);
  }
  return plans;
}

}  // namespace gouge
