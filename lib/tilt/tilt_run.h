#pragma once

#include <vector>

#include "lib/certify/motion_checker.h"
#include "lib/tilt/tilt_lattice.h"
#include "lib/tilt/tilt_options.h"

namespace gouge {

/// A path with the data that a tilt needs. All must outlive it; vectors have one entry a move.
struct TiltJob {
  const Toolpath& path;
  const CheckResult& result;
  const std::vector<const ToolVariants*>& tools;  ///< as in check()
  const MotionChecker& checker;
  const TiltOptions& options;
  const std::vector<bool>& is_wanted;  ///< gouges that a tilt shall cure
};

/// A stretch of one tool's straight moves that must be tilted somewhere. It includes the way before and after it over
/// which the tilt comes and goes.
struct TiltRun {
  std::size_t tool = 0;
  std::size_t first_wanted = 0, last_wanted = 0;  ///< moves that gouge
  std::vector<TiltPosition> positions;  ///< in path order; fixed at both ends, but where the path ends in a collision
};

/// Finds the runs of a path, in its order and apart from each other. Positions are at most `spacing_mm` of the tip's
/// way apart.
///
/// Ensures  Every wanted move that can be tilted (straight, checked, not inside a solid) lies in a run, as far as it is
///          not clean. Long moves are examined piece by piece. No position of a move is in two runs, except for ends.
/// Cost     A check of every piece of the wanted moves, and three of the cutter at each position of a run.
[[nodiscard]] std::vector<TiltRun> find_tilt_runs(const TiltJob& job, double spacing_mm);

/// Returns the run with the directions of its tilts as another freedom has them.
[[nodiscard]] TiltRun with_freedom(TiltRun run, TiltFreedom freedom);

/// Returns wanted moves and those on the way before and after them, arcs and splines too.
[[nodiscard]] std::vector<bool> moves_near(const Toolpath& path, const std::vector<bool>& is_wanted,
                                           double arc_length_mm);

}  // namespace gouge
