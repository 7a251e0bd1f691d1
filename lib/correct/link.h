#pragma once

#include <optional>
#include <vector>

#include "lib/correct/correct_pose.h"

namespace gouge {

/// A position between two others and what it took to find it.
struct LinkPose {
  CorrectedPose corrected;
  Pose before;  ///< where the motion was at that instant
  double depth_before_mm = 0;
};

/// Setup for checks of motions during the search for a path.
struct LinkTask {
  MoveKind kind = MoveKind::feed;
  const ToolVariants* tool = nullptr;
  const MotionChecker* checker = nullptr;
  CheckOptions options;  ///< stricter than those of the checker, so that rounding has a margin
  PoseLimits limits;
  Strategy strategy = Strategy::weighted;
  double rapid_clearance_mm = 0;          ///< clearance of a rapid, where there is room
  bool is_free_as_programmed = false;     ///< the programmed motion does not gouge: only its ends are elsewhere
  std::optional<double> largest_side_mm;  ///< as in free_pose
  /// The programmed motion: where a feed may keep to it, it does, to this distance.
  const Motion* programmed = nullptr;
  double keeps_to_mm = 0;
};

/// Finds positions to visit between `from` and `to` so that every motion between them is clean. The list is empty when
/// the motion is clean already. Returns nothing when no path was found.
///
/// A feed stays on the programmed motion in all time intervals in which that is clean and from which a path leads on.
/// In a gap between them, and in other motions, the worst instant is corrected and both halves are bridged in turn.
/// Where that does not end, the tool retracts along its axis, crosses and comes down again.
///
/// A rapid that must change runs straight where that keeps its clearance, else it retracts and crosses with the
/// clearance. Else it goes round the worst instants with the clearance, and only then as a feed would: clean, without
/// the clearance.
///
/// A position on the straight path between its neighbours is left out where the motion is clean without it. Every shift
/// obeys free_pose.
[[nodiscard]] std::optional<std::vector<LinkPose>> link(const Pose& from, const Pose& to, const LinkTask& task);

}  // namespace gouge
