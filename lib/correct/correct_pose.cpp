#include "lib/correct/correct_pose.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "lib/base/number_text.h"
#include "lib/base/tolerance.h"
#include "lib/certify/check_shift.h"

namespace gouge {

namespace {

constexpr double kSmallestStep_mm = 1e-3;  // minimum step, so that the lift does not become endless where the surface
                                           // runs along the axis
// Contacts have the square of their excess as weight: those below this share of the largest excess are ignored.
constexpr double kNotable = 0.1;
constexpr double kMargin_mm = 2e-3;  // length by which the weighted shift exceeds the required one

/// Returns largest_excess and charges it to the budget of the checker; infinity once the budget is spent.
double tool_excess(const Pose& pose, const ToolVariants& tool, const MotionChecker& checker, const CorrectionAim& aim) {
  if (checker.is_out_of_budget()) return std::numeric_limits<double>::infinity();
  std::uint64_t bounds = 0;
  const double excess = largest_excess(pose, tool, checker.scene(), aim, Tolerance::kCorrection_mm, &bounds);
  checker.charge(bounds + 1);
  return excess;
}

/// Moves the tip to the first place along `way` at which tool and heads meet the aim.
std::optional<CorrectedPose> lift_along(const Vec3& way, Strategy strategy, const Pose& pose, const ToolVariants& tool,
                                        const MotionChecker& checker, const PoseLimits& limits) {
  CorrectedPose result{pose, strategy, 0, 0};
  for (;; ++result.iterations) {
    double excess =
        std::max(tool_excess(result.pose, tool, checker, limits.aim), head_excess(result.pose, checker, limits));
    if (excess <= 0) excess = checker.stock_excess(result.pose);
    if (excess <= 0) return result;
    if (!std::isfinite(excess)) return std::nullopt;
    result.shift_mm += std::max(excess, kSmallestStep_mm);
    if (result.shift_mm > limits.largest_shift_mm) return std::nullopt;
    result.pose.tip = pose.tip + result.shift_mm * way;
  }
}

/// A function that returns the shift of the tip that the contacts of a pose require. Contacts with less than
/// `notable_mm` do not count.
using ShiftOfContacts = Vec3 (*)(const Pose& pose, const ToolVariants& tool, const PreparedScene& scene,
                                 const CorrectionAim& aim, double notable_mm);

Vec3 weighted_mean(const Pose& pose, const ToolVariants& tool, const PreparedScene& scene, const CorrectionAim& aim,
                   double notable_mm) {
  Vec3 sum = Vec3::Zero();
  double weight = 0;
  for (const ToolContact& contact : find_contacts(pose, tool, scene, aim, notable_mm)) {
    sum += contact.excess_mm * contact.excess_mm * contact.normal;
    weight += contact.excess_mm;
  }
  return weight > 0 ? Vec3(sum / weight) : Vec3::Zero();
}

Vec3 of_deepest(const Pose& pose, const ToolVariants& tool, const PreparedScene& scene, const CorrectionAim& aim,
                double notable_mm) {
  const auto deepest = find_deepest_contact(pose, tool, scene, aim, notable_mm);
  return deepest ? Vec3(deepest->excess_mm * deepest->normal) : Vec3::Zero();
}

/// Repeats the shift until the aim is met.
std::optional<CorrectedPose> iterate(ShiftOfContacts shift_of, Strategy strategy, const Pose& pose,
                                     const ToolVariants& tool, const MotionChecker& checker, const PoseLimits& limits) {
  const CorrectionAim& aim = limits.aim;
  const CorrectionAim further{aim.workpiece_mm - kMargin_mm, aim.others_mm - kMargin_mm, aim.clearance_mm - kMargin_mm};
  CorrectedPose result{pose, strategy, 0, 0};
  for (; result.iterations <= limits.largest_iterations; ++result.iterations) {
    const double most = tool_excess(result.pose, tool, checker, aim);
    if (!std::isfinite(most)) return std::nullopt;
    if (most <= 0) return result;
    const Vec3 shift = shift_of(result.pose, tool, checker.scene(), further, kNotable * most);
    if (!(shift.norm() > 0)) return std::nullopt;
    result.pose.tip += shift;
    result.shift_mm = (result.pose.tip - pose.tip).norm();
    if (result.shift_mm > limits.largest_shift_mm) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

const char* strategy_name(Strategy strategy) {
  constexpr std::array kNames = {"weighted", "axis", "tilt", "normal", "direction", "trim"};
  return kNames.at(static_cast<std::size_t>(strategy));
}

std::optional<CorrectedPose> correct_weighted(const Pose& pose, const ToolVariants& tool, const MotionChecker& checker,
                                              const PoseLimits& limits) {
  return iterate(weighted_mean, Strategy::weighted, pose, tool, checker, limits);
}

std::optional<CorrectedPose> correct_along_normal(const Pose& pose, const ToolVariants& tool,
                                                  const MotionChecker& checker, const PoseLimits& limits) {
  return iterate(of_deepest, Strategy::normal, pose, tool, checker, limits);
}

double head_excess(const Pose& pose, const MotionChecker& checker, const PoseLimits& limits) {
  return checker.head_excess(pose, std::max(0.0, limits.aim.workpiece_mm), Tolerance::kCorrection_mm);
}

std::optional<CorrectedPose> correct_along_axis(const Pose& pose, const ToolVariants& tool,
                                                const MotionChecker& checker, const PoseLimits& limits) {
  return lift_along(pose.axis, Strategy::axis, pose, tool, checker, limits);
}

std::optional<CorrectedPose> correct_along_direction(const Pose& pose, const ToolVariants& tool,
                                                     const MotionChecker& checker, const PoseLimits& limits) {
  return lift_along(limits.direction, Strategy::direction, pose, tool, checker, limits);
}

std::optional<CorrectedPose> correct_as(Strategy wanted, const Pose& pose, const ToolVariants& tool,
                                        const MotionChecker& checker, const PoseLimits& limits) {
  std::optional<CorrectedPose> result;
  if (wanted == Strategy::weighted) result = correct_weighted(pose, tool, checker, limits);
  if (wanted == Strategy::normal) result = correct_along_normal(pose, tool, checker, limits);
  if (wanted == Strategy::direction) result = correct_along_direction(pose, tool, checker, limits);
  if (wanted == Strategy::axis) result = correct_along_axis(pose, tool, checker, limits);
  const bool is_free = result && head_excess(result->pose, checker, limits) <= 0;
  return is_free && checker.stock_excess(result->pose) <= 0 ? result : std::nullopt;
}

namespace {

constexpr const char* kThrough = "the way out leads through the surface: on it the tool is deeper than at its start";
constexpr const char* kIntoSolid = "the way out leads into the solid: there the tool is buried";
constexpr const char* kOpenWay = "whether the way out leads into the solid is not certain";
constexpr double kLongerLifts = 10;  // longest lift that a reason may name, in maximum shifts

/// Returns `value` in mm, rounded up to 0.001 mm.
std::string rounded_up(double value) { return display_text(std::ceil(value * 1e3) / 1e3, 3) + " mm"; }

std::string why_aside(double side_mm, const std::optional<double>& given_mm, double limit_mm) {
  return "the way out leads sideways, away from the programmed cut, by " + rounded_up(side_mm) +
         ", more than --max-side-shift allows: " + display_text(limit_mm, 3) + " mm" +
         (given_mm ? "" : ", twice the depth");
}

/// Returns the reason why no strategy finds a place. `has_both` is whether a lift and a shift were sought.
std::string why_no_place(const Pose& pose, const MotionChecker& checker, const PoseLimits& limits, bool has_both) {
  const std::string within = "within " + max_shift_text(limits.largest_shift_mm);
  if (head_excess(pose, checker, limits) > 0)
    return "the head is in the way: no lift along the tool axis " + within +
           " frees it; it takes another tilt or a longer tool";
  if (checker.stock_excess(pose) > 0)
    return "remaining stock is in the way: no lift along the tool axis " + within + " frees the tool";
  return "no way out " + within + (has_both ? ", neither along the tool axis nor as a shift of the cutter" : "");
}

bool is_cutter_in(const Pose& pose, const ToolVariants& tool, const MotionChecker& checker, const PoseLimits& limits) {
  return largest_excess(pose, tool.cutting, checker.scene(), limits.aim.workpiece_mm, Tolerance::kCorrection_mm) > 0;
}

/// Moves the tip along the normal of the triangle in which the tool is deepest; if the cutter is too deep, that in which
/// the cutter is. At the lower end of a shank the nearest way out leads along the axis, and does not end there.
std::optional<CorrectedPose> correct_along_face(const Pose& pose, const ToolVariants& tool,
                                                const MotionChecker& checker, const PoseLimits& limits) {
  auto deepest = find_deepest_contact(pose, tool.cutting, checker.scene().workpiece_tree(), limits.aim.workpiece_mm);
  if (!deepest) deepest = find_deepest_contact(pose, tool, checker.scene(), limits.aim);
  if (!deepest || !(deepest->face.squaredNorm() > 0)) return std::nullopt;
  auto found = lift_along(deepest->face, Strategy::normal, pose, tool, checker, limits);
  if (found && head_excess(found->pose, checker, limits) > 0) return std::nullopt;
  return found;
}

/// A way to seek a place. Without a strategy it is correct_along_face.
using Way = std::optional<Strategy>;
constexpr Way kAlongFace = std::nullopt;

std::optional<CorrectedPose> correct_by(Way way, const Pose& pose, const ToolVariants& tool,
                                        const MotionChecker& checker, const PoseLimits& limits) {
  if (!way) return correct_along_face(pose, tool, checker, limits);
  if (*way == Strategy::axis) return correct_along_axis(pose, tool, checker, limits);
  return correct_as(*way, pose, tool, checker, limits);
}

/// Ways to try.
struct Ways {
  std::vector<Way> in_order;
  bool takes_shortest = false;  ///< the shortest shift is taken, else the first one
};

Ways ways_of(Strategy wanted, const Pose& pose, const ToolVariants& tool, const MotionChecker& checker,
             const PoseLimits& limits) {
  if (wanted == Strategy::normal) return {{wanted, Strategy::axis, kAlongFace}};
  if (wanted == Strategy::tilt && limits.of_cutter) {
    if (is_cutter_in(pose, tool, checker, limits)) return {{limits.of_cutter, kAlongFace, Strategy::axis}, true};
    return {{Strategy::axis, limits.of_cutter, kAlongFace}};
  }
  if (wanted == Strategy::axis || wanted == Strategy::tilt) return {{Strategy::axis}};
  return {{wanted, Strategy::axis}};
}

}  // namespace

const char* why_not_shift(const Pose& from, const Pose& to, MoveKind kind, const ToolVariants& tool,
                          const MotionChecker& checker) {
  switch (check_shift(from, to, kind, tool, checker.without_stock())) {
    case ShiftHazard::none:
      return nullptr;
    case ShiftHazard::deeper:
      return kThrough;
    case ShiftHazard::into_solid:
      return kIntoSolid;
    case ShiftHazard::undecided:
      break;
  }
  return kOpenWay;
}

double side_shift_mm(const Vec3& shift, const Vec3& axis) { return (shift - shift.dot(axis) * axis).norm(); }

std::string max_shift_text(double max_shift_mm) { return "--max-shift " + display_text(max_shift_mm, 3) + " mm"; }

FreedPose free_pose(Strategy wanted, const Pose& pose, double depth_mm, MoveKind kind, const ToolVariants& tool,
                    const MotionChecker& checker, const PoseLimits& limits,
                    const std::optional<double>& largest_side_mm) {
  const double side = largest_side_mm.value_or(kSideShiftsPerDepth * depth_mm);
  const Ways ways = ways_of(wanted, pose, tool, checker, limits);
  FreedPose freed;
  PoseLimits shorter = limits;
  for (const Way& way : ways.in_order) {
    // A lift that becomes longer than the shortest shift so far is not taken.
    if (freed.corrected) shorter.largest_shift_mm = freed.corrected->shift_mm;
    const auto shifted = correct_by(way, pose, tool, checker, shorter);
    if (!shifted) continue;
    const double aside = way == Strategy::axis ? 0 : side_shift_mm(shifted->pose.tip - pose.tip, pose.axis);
    if (aside > side) {
      freed.reason = why_aside(aside, largest_side_mm, side);
      continue;
    }
    const char* const why_not = why_not_shift(pose, shifted->pose, kind, tool, checker);
    if (why_not != nullptr) {
      freed.reason = why_not;
    } else if (!freed.corrected || shifted->shift_mm < freed.corrected->shift_mm) {
      freed.corrected = shifted;
      if (!ways.takes_shortest) break;
    }
  }
  if (freed.corrected) return {freed.corrected, {}};
  const bool has_both = wanted == Strategy::tilt && ways.in_order.size() > 1;
  if (freed.reason.empty()) freed.reason = why_no_place(pose, checker, limits, has_both);
  return freed;
}

std::string longer_lift(const Pose& pose, MoveKind kind, const ToolVariants& tool, const MotionChecker& checker,
                        const PoseLimits& limits) {
  PoseLimits longer = limits;
  longer.largest_shift_mm *= kLongerLifts;
  const auto lifted = correct_along_axis(pose, tool, checker, longer);
  if (!lifted || lifted->shift_mm <= limits.largest_shift_mm ||
      why_not_shift(pose, lifted->pose, kind, tool, checker) != nullptr)
    return {};
  const std::string length = rounded_up(lifted->shift_mm);
  return "; a lift of " + length + " along the tool axis would free it: --max-shift " + length;
}

}  // namespace gouge
