#pragma once

#include <optional>

#include "lib/correct/correct_pose.h"

namespace gouge {

/// check_shift in words: why the tool may not be shifted straight from `from` to `to`, or null: it may.
[[nodiscard]] const char* why_not_shift(const Pose& from, const Pose& to, MoveKind kind, const ToolVariants& tool,
                                        const MotionChecker& checker);

/// A pose freed by a shift that may be made, or the reason there is none.
struct FreedPose {
  std::optional<CorrectedPose> corrected;
  const char* reason = nullptr;
};

/// The largest sideways shift where the command line names none: this many times the depth at the pose.
inline constexpr double kSideShiftsPerDepth = 2;

/// How far a shift leads away from the tool axis: along the axis the tool keeps to the programmed cut.
[[nodiscard]] double side_shift_mm(const Vec3& shift, const Vec3& axis);

/// correct_as, held to the laws of a shift: `wanted` first, then along the axis.
///
/// `largest_side_mm`: none allows kSideShiftsPerDepth times the depth.
[[nodiscard]] FreedPose free_pose(Strategy wanted, const Pose& pose, double depth_mm, MoveKind kind,
                                  const ToolVariants& tool, const MotionChecker& checker, const PoseLimits& limits,
                                  const std::optional<double>& largest_side_mm);

}  // namespace gouge
