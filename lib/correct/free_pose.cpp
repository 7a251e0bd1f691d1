#include "lib/correct/free_pose.h"

#include <algorithm>

namespace gouge {
namespace {

constexpr const char* kTooFar = "no way out within the largest shift";
constexpr const char* kSideways =
    "the way out leads sideways, away from the programmed cut, by more than --max-side-shift allows";
constexpr const char* kThrough = "the way out leads through the surface: on it the tool is deeper than at its start";
constexpr const char* kIntoSolid = "the way out leads into the solid: there the tool is buried";
constexpr const char* kOpenWay = "whether the way out leads into the solid is not certain";
constexpr const char* kHeadStays =
    "the head is in the way: no lift along the tool axis within the largest shift frees it; it takes another "
    "tilt or a longer tool";
constexpr double kHeadShare = 0.02;       // of the depth at the start: how exactly the way of a head is known
constexpr double kLeastStretch_mm = 1e-4;  // of a shift, below which "not buried" is given up

/// "Never buried" along a shift: stretch by stretch, either a surface stays inside the tool, which is then not buried
/// but a gouge, or none reaches the middle of the cutter, which then stays on one side.
class ShiftSides {
 public:
  ShiftSides(const Pose& from, const Pose& to, MoveKind kind, const ToolForms& tool, const MotionChecker& checker)
      : from_(from), way_(to.tip - from.tip), length_(way_.norm()), kind_(kind), tool_(tool), checker_(checker) {
    options_ = checker.options();
    options_.tolerance_mm = options_.near_miss_mm = 0;
    options_.is_depth_alone = true;
  }

  const char* why_not(double t0, double t1) const {
    const double half = 0.5 * (t1 - t0) * length_;
    const Pose middle{from_.tip + 0.5 * (t0 + t1) * way_, from_.axis};
    const MoveVerdict there = check_move(Motion(middle), kind_, tool_, checker_.scene(), options_);
    if (there.depth_mm > half) return nullptr;
    if (there.depth_upper_mm + half < tool_.bare.core_depth_mm) {
      const Side side = checker_.side_of(middle, tool_);
      return side == Side::inside ? kIntoSolid : nullptr;
    }
    if (half < kLeastStretch_mm) return kOpenWay;
    const double t = 0.5 * (t0 + t1);
    if (const char* reason = why_not(t0, t)) return reason;
    return why_not(t, t1);
  }

 private:
  const Pose& from_;
  Vec3 way_;
  double length_;
  MoveKind kind_;
  const ToolForms& tool_;
  const MotionChecker& checker_;
  CheckOptions options_;
};

// The search that heads take does not close the depth of a long way to the resolution.
const char* why_not_shift_heads(const Motion& motion, double depth_mm, const MotionChecker& checker) {
  CheckOptions options = checker.options();
  options.near_miss_mm = 0;
  options.tolerance_mm = depth_mm + std::max(options.resolution_mm, kHeadShare * depth_mm);
  MoveVerdict way;
  checker.heads()->check(motion, options, way);
  if (way.state == MoveState::clean) return nullptr;
  return way.state == MoveState::gouge ? kThrough : way.state == MoveState::buried ? kIntoSolid : kOpenWay;
}

}  // namespace

const char* why_not_shift(const Pose& from, const Pose& to, MoveKind kind, const ToolForms& tool,
                          const MotionChecker& checker) {
  const double resolution = checker.options().resolution_mm;
  const MoveVerdict start = checker.measure(from, kind, tool);
  if (start.state == MoveState::not_certified || start.state == MoveState::not_checked) return kOpenWay;
  if (start.state == MoveState::buried) return kIntoSolid;
  CheckOptions options = checker.options();
  options.tolerance_mm = start.depth_mm;
  options.near_miss_mm = 0;
  options.is_depth_alone = true;
  options.gouge_gap_mm = resolution;
  // Whether the tool is inside is asked below, also where the surface reaches its middle.
  const MoveVerdict way = check_move(Motion(from, to), kind, tool, checker.scene(), options);
  if (way.state == MoveState::not_certified || way.state == MoveState::not_checked) return kOpenWay;
  if (way.depth_upper_mm > start.depth_mm + 2 * resolution) return kThrough;
  if (checker.heads() != nullptr) {
    if (const char* reason = why_not_shift_heads(Motion(from, to), start.depth_mm, checker)) return reason;
  }
  if (way.depth_upper_mm < tool.bare.core_depth_mm)
    return checker.side_of(to, tool) == Side::inside ? kIntoSolid : nullptr;
  return ShiftSides(from, to, kind, tool, checker).why_not(0, 1);
}

double side_shift_mm(const Vec3& shift, const Vec3& axis) {
  return (shift - shift.dot(axis) * axis).norm();
}

FreedPose free_pose(Strategy wanted, const Pose& pose, double depth_mm, MoveKind kind, const ToolForms& tool,
                    const MotionChecker& checker, const PoseLimits& limits,
                    const std::optional<double>& largest_side_mm) {
  const double side = largest_side_mm.value_or(kSideShiftsPerDepth * depth_mm);
  const bool is_head_in = head_excess(pose, limits) > 0;
  FreedPose freed;
  freed.reason = is_head_in ? kHeadStays : kTooFar;
  if (wanted == Strategy::weighted) {
    const auto shifted = correct_weighted(pose, tool, checker.scene(), limits);
    if (shifted && head_excess(shifted->pose, limits) <= 0) {
      const bool is_aside = side_shift_mm(shifted->pose.tip - pose.tip, pose.axis) > side;
      freed.reason = is_aside ? kSideways : why_not_shift(pose, shifted->pose, kind, tool, checker);
      if (freed.reason == nullptr) return {shifted, nullptr};
    }
  }
  const auto lifted = correct_along_axis(pose, tool, checker.scene(), limits);
  if (!lifted) return freed;
  freed.reason = why_not_shift(pose, lifted->pose, kind, tool, checker);
  if (freed.reason == nullptr) freed.corrected = lifted;
  return freed;
}

}  // namespace gouge
