#pragma once

#include <string>
#include <vector>

#include "lib/tilt/tilt_run.h"

namespace gouge {

/// A position of a tilted run in the new path: the new end of its move, or an added position within the move.
struct TiltedPosition {
  std::size_t move = 0;
  bool is_end = true;
  Pose programmed;  ///< pose of the programmed motion
  Pose pose;
  double tilt_rad = 0;  ///< angle between the two axes
};

struct SmoothedRun {
  std::size_t first_wanted = 0, last_wanted = 0;  ///< moves that gouged
  std::vector<TiltedPosition> positions;          ///< in path order; without the ends of moves that do not change
};

/// A run that no tilt makes free.
struct UntiltedRun {
  std::size_t first_wanted = 0, last_wanted = 0;
  std::string reason;
};

struct TiltPlan {
  std::vector<SmoothedRun> runs;
  std::vector<UntiltedRun> failed;
};

/// Returns smooth tilts for all wanted moves of a path. They are certified at every instant of the changed motions.
///
/// Ensures  The plan is the same at any number of threads.
/// Source   docs/method/tilting.md
[[nodiscard]] TiltPlan plan_tilts(const TiltJob& job, const ProgressCall& progress);

}  // namespace gouge
