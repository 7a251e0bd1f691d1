#pragma once

#include <string>
#include <vector>

#include "lib/correct/reworked_path.h"

// Leaves out gouging stretches: the tool retracts along its axis where the path was last free, crosses, and comes down
// again where it is free. The stretch between stays uncut.

namespace gouge {

/// A place of a straight path: t in [0, 1] of a move.
struct PathPlace {
  std::size_t move = 0;
  double t = 0;
};

/// A stretch that is left out, from `begin` to `end`.
struct Trim {
  PathPlace begin, end;                ///< where the tool leaves the programmed path, and where it is back
  std::vector<NewPosition> positions;  ///< of the moves from begin.move to end.move, in path order
  std::vector<Pose> programmed;        ///< where each of them was
  std::size_t uncut_positions = 0;     ///< programmed ones that are not visited
  double uncut_mm = 0;                 ///< of the tip's programmed feeds
  double lift_mm = 0;                  ///< along the tool axis
};

/// A stretch that stays as it is, and why.
struct Untrimmed {
  std::size_t first = 0, last = 0;  ///< wanted moves
  std::string reason;
};

struct TrimPlan {
  std::vector<Trim> trims;  ///< in path order, apart from each other
  std::vector<Untrimmed> failed;
};

/// A path of which some moves are to be left out. All must outlive it; vectors have one entry a move.
struct TrimJob {
  const Toolpath& path;
  const CheckResult& result;
  const std::vector<const ToolVariants*>& tools;
  const MotionChecker& checker;
  const std::vector<bool>& is_wanted;
  double max_lift_mm = 20;
  double clearance_mm = 1;        ///< clearance of the crossing where there is room
  bool can_write_rapids = false;  ///< a feed may become a rapid
};

/// Leaves out, of every wanted feed, the stretches that are not clean, and of the moves about it as much as that takes.
///
/// Ensures  (1) Every motion of a trim is certified clean to four fifths of the tolerance. Its crossing keeps the
///          clearance too, where any lift gives that; then it is at rapid, where that can be written. Without the
///          clearance it is a feed. (2) The path outside of trims stays as programmed. Positions that are not visited
///          keep their records. They lie evenly on the straight crossing, or, where that is not clean, above their
///          programmed places. (3) The lift is the least of a growing list. (4) The same plan at any number of threads.
/// Cost     The clean intervals of each move that is not clean. For each stretch also some 16 lifts, each a check of
///          three motions, or of all its moves where the straight crossing is not clean.
[[nodiscard]] TrimPlan plan_trims(const TrimJob& job);

}  // namespace gouge
