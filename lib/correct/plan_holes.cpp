#include "lib/correct/plan_holes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "lib/base/number_text.h"
#include "lib/base/units.h"
#include "lib/check/prepared_scene.h"
#include "lib/contact/contacts.h"
#include "lib/correct/correct_pose.h"
#include "lib/geom/pose.h"
#include "lib/path/run_kind.h"
#include "lib/surface/surface.h"

namespace gouge {
namespace {

constexpr double kBeside = 1.25;  // distance from the axis, in radii, at which material is searched
constexpr int kDirections = 8, kHeights = 64;
constexpr double kTopExact_mm = 1e-3;

bool is_in_part(const Vec3& point, const PreparedScene& scene) {
  return std::ranges::any_of(scene.workpiece().surfaces,
                             [&](const Surface& surface) { return surface.is_solid() && surface.winds_around(point); });
}

/// Returns the height at which the material that begins beside the drill ends; 0 if there is none.
double top_mm(const Vec3& foot, const Vec3& axis, double max_mm, const PreparedScene& scene) {
  const auto is_in = [&](double height) { return is_in_part(foot + height * axis, scene); };
  double in = 0, out = max_mm;
  bool is_found = false;
  for (int k = 0; k <= kHeights; ++k) {
    const double height = std::max(max_mm * (k - 0.5) / kHeights, kTopExact_mm);
    if (is_in(height)) {
      is_found = true;
      in = height;
    } else if (is_found) {
      out = height;
      break;
    }
  }
  if (!is_found) return 0;
  while (out - in > kTopExact_mm) {
    const double middle = 0.5 * (in + out);
    (is_in(middle) ? in : out) = middle;
  }
  return in;
}

// Returns how deep the tip of a drill is below the surface of the parts around it, in mm. Returns 0 if material does
// not surround it, or if a part is not a solid. The result does not depend on whether the parts have the hole.
//
// At `pose` the tip is at the bottom of the hole. The radius is that of the drill. Nothing above `max_mm` is examined.
// Ensures  In each of eight directions about the axis, there is material at 1.25 radii from the axis up to that depth.
//          This is tested at 64 heights; the upper end is known to 0.001 mm.
// Cost     Some 600 queries of a side.
double depth_below_surface_mm(const Pose& pose, double radius_mm, double max_mm, const PreparedScene& scene) {
  if (!(max_mm > 0) || !scene.is_within_reach) return 0;
  const Vec3 across = pose.axis.unitOrthogonal(), other = pose.axis.cross(across);
  double least = max_mm;
  for (int k = 0; k < kDirections && least > 0; ++k) {
    const double angle = 2 * std::numbers::pi * (k + 0.5) / kDirections;
    const Vec3 away = kBeside * radius_mm * (std::cos(angle) * across + std::sin(angle) * other);
    least = std::min(least, top_mm(pose.tip + away, pose.axis, max_mm, scene));
  }
  return least;
}

constexpr double kMinStep_mm = 5e-4;
constexpr int kSteps = 40;
// A longer lift would leave no hole, or a different hole from the programmed one.
constexpr double kMaxOfDepth = 0.25, kMaxOfDiameter = 0.25;
constexpr double kNoHole = 0.02;  // share of the depth: a hole of the part that is no deeper does not count as a hole

class HolePlanner {
 public:
  HolePlanner(const Toolpath& path, const CheckResult& result, const std::vector<const ToolVariants*>& tools,
              const MotionChecker& checker, const CorrectOptions& correct)
      : path_(path), result_(result), tools_(tools), checker_(checker), correct_(correct) {}

  void plan(std::size_t first, bool is_writable, HolePlans& plans) const {
    HolePlan plan;
    plan.first = first;
    plan.last = end_of_hole(path_, first);
    std::vector<std::size_t> gouging;
    for (std::size_t i = first; i < plan.last; ++i) {
      const MoveVerdict& verdict = result_.verdicts[i];
      if (verdict.state == MoveState::buried || verdict.state == MoveState::not_checked) return;
      if (verdict.is_in_stock()) return;  // where the drill itself is free, a lift of the hole is no way out
      if (verdict.state != MoveState::gouge) continue;
      gouging.push_back(i);
      plan.depth_before_mm = std::max(plan.depth_before_mm, verdict.depth_mm);
    }
    const double depth_mm = programmed_depth_mm(plan);
    const std::optional<double> lift = find_lift(gouging, std::max(correct_.max_shift_mm, 2 * depth_mm));
    if (!lift) return;
    const double most =
        std::min({correct_.max_shift_mm, kMaxOfDepth * depth_mm, 2 * kMaxOfDiameter * tool_of(first).cutting.r_max_mm});
    plan.shift_mm = *lift * path_.moves[first].end.axis;
    if (*lift > most) {
      if (depth_mm > 0) plans.left.push_back({first, plan.last, depth_reason(depth_mm, depth_mm - *lift)});
    } else if (is_writable && keeps_law(gouging, plan.shift_mm)) {
      for (const std::size_t i : gouging) plan.depth_after_mm = std::max(plan.depth_after_mm, depth(i, plan.shift_mm));
      plans.lifted.push_back(plan);
    }
  }

 private:
  /// Returns the smallest lift, up to `max_mm`, with which the gouging steps are clean.
  [[nodiscard]] std::optional<double> find_lift(const std::vector<std::size_t>& gouging, double max_mm) const {
    const Vec3 axis = path_.moves[gouging.front()].end.axis;
    double lift = 0;
    for (int step = 0; step < kSteps; ++step) {
      lift += std::max(kMinStep_mm, excess(gouging, lift * axis));
      if (lift > max_mm) return std::nullopt;
      if (is_clean(gouging, lift * axis)) return lift;
    }
    return std::nullopt;
  }

  /// Returns the depth of the hole's lowest step below the surface that surrounds the drill.
  [[nodiscard]] double programmed_depth_mm(const HolePlan& hole) const {
    const Vec3 axis = path_.moves[hole.first].end.axis;
    const Pose* lowest = &path_.moves[hole.first].end;
    double highest = lowest->tip.dot(axis);
    for (std::size_t i = hole.first; i < hole.last; ++i) {
      const Pose& end = path_.moves[i].end;
      if (end.tip.dot(axis) < lowest->tip.dot(axis)) lowest = &end;
      highest = std::max(highest, end.tip.dot(axis));
    }
    return depth_below_surface_mm(*lowest, tool_of(hole.first).cutting.r_max_mm, highest - lowest->tip.dot(axis),
                                  checker_.scene());
  }

  [[nodiscard]] std::string depth_reason(double programmed_mm, double of_part_mm) const {
    const LengthUnit unit = path_.unit;
    const double allowed = 2 * checker_.options().tolerance_mm + checker_.options().resolution_mm;
    const auto text = [unit](double length_mm) {
      return display_text(length_mm / mm_per(unit), unit == LengthUnit::mm ? 2 : 3) + " " + unit_name(unit);
    };
    return "hole " + text(programmed_mm) + " deep where the part has " +
           (of_part_mm > std::max(kNoHole * programmed_mm, allowed) ? "one of " + text(of_part_mm) : "none");
  }

  [[nodiscard]] Motion shifted(std::size_t i, const Vec3& by) const {
    const Pose &start = path_.start_of(i), &end = path_.moves[i].end;
    return checker_.options().law.between({start.tip + by, start.axis}, {end.tip + by, end.axis},
                                          run_kind(path_.moves[i]));
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
      const MoveVerdict verdict = checker_.check(shifted(i, by), run_kind(path_.moves[i]), tool_of(i), options);
      const bool is_air = verdict.witness && !rule_of(verdict.witness->against).is_workpiece;
      const double aim = is_air ? -kAir_mm : options.tolerance_mm;
      if (verdict.state == MoveState::gouge) most = std::max(most, verdict.depth_mm - aim);
    }
    return most;
  }
  [[nodiscard]] bool is_clean(const std::vector<std::size_t>& gouging, const Vec3& by) const {
    return std::all_of(gouging.begin(), gouging.end(), [&](std::size_t i) {
      return checker_.is_clean(shifted(i, by), run_kind(path_.moves[i]), tool_of(i), within(kMotionAimShare));
    });
  }
  [[nodiscard]] double depth(std::size_t i, const Vec3& by) const {
    return checker_.check(shifted(i, by), run_kind(path_.moves[i]), tool_of(i), within(0)).depth_mm;
  }
  [[nodiscard]] bool keeps_law(const std::vector<std::size_t>& gouging, const Vec3& by) const {
    return std::all_of(gouging.begin(), gouging.end(), [&](std::size_t i) {
      const Pose& end = path_.moves[i].end;
      return why_not_shift(end, {end.tip + by, end.axis}, run_kind(path_.moves[i]), tool_of(i), checker_) == nullptr;
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

HolePlans plan_holes(const Toolpath& path, const CheckResult& result, const std::vector<const ToolVariants*>& tools,
                     const MotionChecker& checker, const CorrectOptions& correct) {
  HolePlans plans;
  const HolePlanner planner(path, result, tools, checker, correct);
  const auto is_first = [&](std::size_t i) { return path.moves[i - 1].statement != path.moves[i].statement; };
  for (std::size_t i = 1, last = 2; i < path.moves.size(); i = last) {
    last = i + 1;
    if (path.moves[i].kind != MoveKind::cycle || !path.moves[i].has_start || !is_first(i)) continue;
    last = end_of_hole(path, i);
    const auto is_gouging = [](const MoveVerdict& v) { return v.state == MoveState::gouge; };
    if (std::none_of(result.verdicts.begin() + static_cast<std::ptrdiff_t>(i),
                     result.verdicts.begin() + static_cast<std::ptrdiff_t>(last), is_gouging))
      continue;
    // For a statement of several positions it is not known which moves belong to which position.
    const bool can_rewrite = correct.rewritable != nullptr && !correct.rewritable->hole.empty();
    const auto holes = can_rewrite
                           ? std::count(correct.rewritable->hole.begin() + static_cast<std::ptrdiff_t>(i),
                                        correct.rewritable->hole.begin() + static_cast<std::ptrdiff_t>(last), true)
                           : 0;
    if (holes <= 1) planner.plan(i, holes == 1 && correct.rewritable->hole[i], plans);
  }
  return plans;
}

}  // namespace gouge
