#include "lib/correct/correct_pose.h"

#include <algorithm>
#include <cmath>

namespace gouge {
namespace {

constexpr double kAccuracy_mm = 2e-4;
constexpr double kSmallestStep_mm = 1e-3;  // keeps the lift from creeping where the surface runs along the axis
// Contacts count by the square of their excess: those below this share of the largest are of no account.
constexpr double kNotable = 0.1;
constexpr double kMargin_mm = 2e-3;  // how much further than asked the weighted shift reaches

}  // namespace

const char* strategy_name(Strategy strategy) {
  constexpr std::array kNames = {"weighted", "axis", "tilt"};
  return kNames.at(static_cast<std::size_t>(strategy));
}

std::optional<CorrectedPose> correct_weighted(const Pose& pose, const ToolVariants& tool, const MotionChecker& checker,
                                              const PoseLimits& limits) {
  const CorrectionAim& aim = limits.aim;
  const CorrectionAim further{aim.part_mm - kMargin_mm, aim.fixture_mm - kMargin_mm, aim.clearance_mm - kMargin_mm};
  CorrectedPose result{pose, Strategy::weighted, 0, 0};
  for (; result.iterations <= limits.largest_iterations; ++result.iterations) {
    const double most = largest_excess(result.pose, tool, checker.scene(), aim, kAccuracy_mm);
    if (most <= 0) return result;
    Vec3 sum = Vec3::Zero();
    double weight = 0;
    for (const ToolContact& contact : find_contacts(result.pose, tool, checker.scene(), further, kNotable * most)) {
      sum += contact.excess_mm * contact.excess_mm * contact.normal;
      weight += contact.excess_mm;
    }
    if (!(weight > 0)) return std::nullopt;
    result.pose.tip += sum / weight;
    result.shift_mm = (result.pose.tip - pose.tip).norm();
    if (result.shift_mm > limits.largest_shift_mm) return std::nullopt;
  }
  return std::nullopt;
}

double head_excess(const Pose& pose, const MotionChecker& checker, const PoseLimits& limits) {
  return checker.head_excess(pose, std::max(0.0, limits.aim.part_mm), kAccuracy_mm);
}

std::optional<CorrectedPose> correct_along_axis(const Pose& pose, const ToolVariants& tool,
                                                const MotionChecker& checker, const PoseLimits& limits) {
  CorrectedPose result{pose, Strategy::axis, 0, 0};
  for (;; ++result.iterations) {
    const double excess = std::max(largest_excess(result.pose, tool, checker.scene(), limits.aim, kAccuracy_mm),
                                   head_excess(result.pose, checker, limits));
    if (excess <= 0) return result;
    if (!std::isfinite(excess)) return std::nullopt;
    result.shift_mm += std::max(excess, kSmallestStep_mm);
    if (result.shift_mm > limits.largest_shift_mm) return std::nullopt;
    result.pose.tip = pose.tip + result.shift_mm * pose.axis;
  }
}

std::optional<CorrectedPose> correct_pose(Strategy wanted, const Pose& pose, const ToolVariants& tool,
                                          const MotionChecker& checker, const PoseLimits& limits) {
  if (wanted == Strategy::weighted) {
    const auto result = correct_weighted(pose, tool, checker, limits);
    if (result && head_excess(result->pose, checker, limits) <= 0) return result;
  }
  return correct_along_axis(pose, tool, checker, limits);
}

}  // namespace gouge
