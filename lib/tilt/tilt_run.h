#pragma once

#include <vector>

#include "lib/certify/motion_checker.h"
#include "lib/tilt/tilt_lattice.h"
#include "lib/tilt/tilt_options.h"

namespace gouge {

/// A path with the data that tilting needs. The referenced objects must outlive it; vectors have one entry for each
/// move.
struct TiltJob {
  const Toolpath& path;
  const CheckResult& result;
  const std::vector<const ToolVariants*>& tools;  ///< as in check()
  const MotionChecker& checker;
  const TiltOptions& options;
  const std::vector<bool>& is_wanted;  ///< moves whose gouges tilts shall remove
  /// For each move, the move of the path of remaining stock of which it is a piece; null: the path is that one.
  const std::vector<std::size_t>* origin = nullptr;

  [[nodiscard]] std::size_t origin_of(std::size_t move) const { return origin != nullptr ? (*origin)[move] : move; }
  /// Returns the checker for feeds in place of a move, with the material that is left before it.
  [[nodiscard]] MotionChecker checker_of(std::size_t move) const {
    return checker.for_move(origin_of(move), false).searching();
  }
};

/// A stretch of straight moves of one tool that must be tilted somewhere. It includes the parts before and after, on
/// which the tilt increases and decreases.
struct TiltRun {
  std::size_t tool = 0;
  std::size_t first_wanted = 0, last_wanted = 0;  ///< moves that gouge
  std::vector<TiltPosition> positions;  ///< in path order; fixed at both ends, unless the path ends there in a
                                        ///< collision
};

/// Returns whether a move is not certified because a tool touched the stock there before. Once that tool is led elsewhere,
/// the move meets the stock.
[[nodiscard]] inline bool may_be_in_stock(const MoveVerdict& verdict) {
  return verdict.state == MoveState::not_certified && verdict.reason.is(Reason::Kind::stock_touched);
}

/// Finds the runs of a path, in path order. No two of them overlap. Positions are at most `spacing_mm` of the tip's
/// path apart.
///
/// Ensures  Every wanted move that can be tilted (straight, checked, not inside a solid) lies in a run, except for its
///          clean parts. Long moves are examined piece by piece. No position of a move is in two runs, except for ends.
/// Cost     A check of every piece of the wanted moves, and three checks of the cutter at each position of a run.
[[nodiscard]] std::vector<TiltRun> find_tilt_runs(const TiltJob& job, double spacing_mm);

/// Returns the run with directions of tilt for another freedom.
[[nodiscard]] TiltRun with_freedom(TiltRun run, TiltFreedom freedom);

/// Returns the wanted moves and the moves shortly before and after them, including arcs and splines.
[[nodiscard]] std::vector<bool> moves_near(const Toolpath& path, const std::vector<bool>& is_wanted,
                                           double arc_length_mm);

}  // namespace gouge
