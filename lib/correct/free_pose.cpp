#include "lib/correct/free_pose.h"

#include "lib/certify/check_shift.h"

namespace gouge {
namespace {

constexpr const char* kTooFar = "no way out within the largest shift";
constexpr const char* kSideways =
    "the way out leads sideways, away from the programmed cut, by more than --max-side-shift allows";
constexpr const char* kThrough = "the way out leads through the surface: on it the tool is deeper than at its start";
constexpr const char* kIntoSolid = "the way out leads into the solid: there the tool is buried";
constexpr const char* kOpenWay = "whether the way out leads into the solid is not certain";
constexpr const char* kHeadStays =
    "the head is in the way: no lift along the tool axis within the largest shift frees it; it takes another tilt or a "
    "longer tool";

}  // namespace

const char* why_not_shift(const Pose& from, const Pose& to, MoveKind kind, const ToolVariants& tool,
                          const MotionChecker& checker) {
  switch (check_shift(from, to, kind, tool, checker)) {
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

FreedPose free_pose(Strategy wanted, const Pose& pose, double depth_mm, MoveKind kind, const ToolVariants& tool,
                    const MotionChecker& checker, const PoseLimits& limits,
                    const std::optional<double>& largest_side_mm) {
  const double side = largest_side_mm.value_or(kSideShiftsPerDepth * depth_mm);
  const bool is_head_in = head_excess(pose, checker, limits) > 0;
  FreedPose freed;
  freed.reason = is_head_in ? kHeadStays : kTooFar;
  if (wanted != Strategy::axis) {
    if (const auto shifted = correct_as(wanted, pose, tool, checker, limits)) {
      const bool is_aside = side_shift_mm(shifted->pose.tip - pose.tip, pose.axis) > side;
      freed.reason = is_aside ? kSideways : why_not_shift(pose, shifted->pose, kind, tool, checker);
      if (freed.reason == nullptr) return {shifted, nullptr};
    }
  }
  const auto lifted = correct_along_axis(pose, tool, checker, limits);
  if (!lifted) return freed;
  freed.reason = why_not_shift(pose, lifted->pose, kind, tool, checker);
  if (freed.reason == nullptr) freed.corrected = lifted;
  return freed;
}

}  // namespace gouge
