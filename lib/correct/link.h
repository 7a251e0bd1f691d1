#pragma once

#include <optional>
#include <vector>

#include "lib/correct/correct_pose.h"

namespace gouge {

/// A position between two others, with data on how it was found.
struct LinkPose {
  CorrectedPose corrected;
  Pose before;  ///< pose of the motion at that instant
  double depth_before_mm = 0;
};

/// Settings for the checks of motions during the search for a path.
struct LinkTask {
  MoveKind kind = MoveKind::feed;
  const ToolVariants* tool = nullptr;
  const MotionChecker* checker = nullptr;
  CheckOptions options;  ///< stricter than the options of the checker, as a margin for rounding
  PoseLimits limits;
  Strategy strategy = Strategy::weighted;
  double rapid_clearance_mm = 0;          ///< clearance of a rapid, if there is room
  bool is_free_as_programmed = false;     ///< the programmed motion does not gouge; only its ends have moved
  std::optional<double> largest_side_mm;  ///< as in free_pose
  /// The programmed motion. A feed stays within `keeps_to_mm` of it where possible.
  const Motion* programmed = nullptr;
  double keeps_to_mm = 0;
};

/// Finds positions to visit between `from` and `to` so that every motion between them is clean. The list is empty if
/// the motion is already clean. Returns nothing if no path was found.
///
/// A feed stays on the programmed motion in every time interval in which that is clean and from which a path continues.
/// In a gap between these intervals, and in other motions, the worst instant is corrected, and both halves are bridged
/// in turn. If that does not end, the tool retracts along its axis, crosses, and comes down again.
///
/// A rapid that must change takes the first possible path. The first choice is a straight path with the clearance. At a
/// contact at its start or end it need not have it. The next is to retract and cross with the clearance. Then it goes
/// around the worst instants with the clearance. Otherwise it moves like a feed: clean, but without the clearance.
///
/// A position on the straight path between its neighbours is left out if the motion is clean without it. Every shift
/// obeys free_pose.
[[nodiscard]] std::optional<std::vector<LinkPose>> link(const Pose& from, const Pose& to, const LinkTask& task);

}  // namespace gouge
