#pragma once

#include <string>
#include <vector>

#include "lib/tilt/tilt_run.h"

namespace gouge {

/// A position of a tilted run that is written: the new end of its move, or a position on the way to it.
struct TiltedPosition {
  std::size_t move = 0;
  bool is_end = true;
  Pose programmed;  ///< where the motion was
  Pose pose;
  double tilt_rad = 0;  ///< between both axes
};

struct SmoothedRun {
  std::size_t first_wanted = 0, last_wanted = 0;  ///< moves that gouged
  std::vector<TiltedPosition> positions;          ///< in path order; the ends of moves that stay are not among them
};

/// A run that no tilt frees.
struct UntiltedRun {
  std::size_t first_wanted = 0, last_wanted = 0;
  std::string reason;
};

struct TiltPlan {
  std::vector<SmoothedRun> runs;
  std::vector<UntiltedRun> failed;
};

/// Returns tilts for all wanted moves of a path: smooth, and certified at every instant of the changed motions.
///
/// Ensures  The same plan at any number of threads.
/// Source   docs/method/tilting.md
[[nodiscard]] TiltPlan plan_tilts(const TiltJob& job, const ProgressCall& progress);

}  // namespace gouge
