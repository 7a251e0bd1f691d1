#pragma once

#include <string>
#include <vector>

#include "lib/correct/reworked_path.h"

// Leaves out gouging stretches. The tool retracts along its axis where the path was last free, crosses, and comes down
// where the path is free again. The stretch between stays uncut.

namespace gouge {

/// A place of a straight path: instant t in [0, 1] of a move.
struct PathPlace {
  std::size_t move = 0;
  double t = 0;
};

/// A stretch that is left out, from `begin` to `end`.
struct Trim {
  PathPlace begin, end;                ///< places at which the tool leaves the programmed path and returns to it
  std::vector<NewPosition> positions;  ///< positions of the moves from begin.move to end.move, in path order
  std::vector<Pose> programmed;        ///< the programmed pose of each position
  std::size_t uncut_positions = 0;     ///< number of programmed positions that are not visited
  double uncut_mm = 0;                 ///< length of the tip's programmed feeds
  double lift_mm = 0;                  ///< lift along the tool axis
};

/// A stretch that stays as it is, and the reason.
struct Untrimmed {
  std::size_t first = 0, last = 0;  ///< the first and last wanted move
  std::string reason;
};

struct TrimPlan {
  std::vector<Trim> trims;  ///< in path order, without contact to each other
  std::vector<Untrimmed> failed;
};

/// A path of which some moves are to be left out. All objects must outlive it; vectors have one entry for each move.
struct TrimJob {
  const Toolpath& path;
  const CheckResult& result;
  const std::vector<const ToolVariants*>& tools;
  const MotionChecker& checker;
  const std::vector<bool>& is_wanted;
  double max_lift_mm = 20;
  double clearance_mm = 1;        ///< clearance of the crossing, if there is room
  bool can_write_rapids = false;  ///< whether a feed may become a rapid
};

/// Leaves out the stretches of every wanted feed that are not clean, and as much of the neighbouring moves as
/// necessary.
///
/// Ensures  (1) Every motion of a trim is certified clean to four fifths of the tolerance. The crossing also keeps the
///          clearance if any lift permits it; then it is a rapid if that can be written. Without the clearance it is a
///          feed. (2) The path outside of trims stays as programmed. Positions that are not visited keep their records.
///          They lie evenly on the straight crossing or, if that is not clean, above their programmed places. (3) The
///          lift is the smallest of a growing list. (4) The plan is the same at any number of threads.
/// Cost     The clean intervals of each move that is not clean. In addition, for each stretch some 16 lifts. Each is a
///          check of three motions, or of all its moves if the straight crossing is not clean.
[[nodiscard]] TrimPlan plan_trims(const TrimJob& job);

}  // namespace gouge
