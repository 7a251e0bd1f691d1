#pragma once

#include <cstddef>
#include <vector>

#include "lib/path/axis_quality.h"
#include "lib/path/toolpath.h"

// Measures the tilt of the axes of a corrected path from the programmed axes, position by position and along the path:
// docs/method/correction.md, "Quality".

namespace gouge {

/// Axes at one place of a corrected path. Both are measured from one direction for the whole run, the mean of its
/// programmed axes. `lead` is the angle forward, towards the feed; `side` is the angle to the left of the feed, seen
/// from the spindle. A feed within some 17 degrees of that direction is a plunge. A plunge is measured in the forward
/// direction of the feed before it, or after it.
struct TiltPlace {
  double length_mm = 0;  ///< length of the corrected path from the beginning of its run's curve
  double lead_before_rad = 0, side_before_rad = 0;
  double lead_after_rad = 0, side_after_rad = 0;
};

/// Neighbouring moves of the corrected path whose axes differ from the programmed ones.
struct TiltedRun {
  std::size_t first = 0, last = 0;  ///< moves [first, last)
  LargestOfMoves tilt_rad;          ///< largest tilt, at the end of its move
  double begin_mm = 0, end_mm = 0;  ///< where the moves begin and end on the curve, between margins of programmed moves
  std::vector<TiltPlace> curve;     ///< has two places of the same length where the feed turns a corner
};

struct AxisTilts {
  LargestOfMoves tilt_rad;      ///< angle between corrected and programmed axis; the move is one of the corrected path
  std::size_t positions = 0;    ///< number of positions whose axes differ from the programmed ones
  std::vector<TiltedRun> runs;  ///< the longest ones, in path order
  std::size_t runs_left_out = 0;  ///< number of shorter runs that are not listed

  /// Minimum tilt, which is coarser than the digits of any file.
  static constexpr double kLeast_rad = 1e-3;
};

/// Finds the tilts of `after`. Its move k results from move `origins[k]` of `before`. The moves of one origin are
/// consecutive. The last of them ends where the original move ends, apart from the correction.
///
/// The programmed axis at the end of a move is that of the same move. For an inserted position it is that of the
/// programmed motion at a near place. The search uses places whose distance is at most twice the smallest distance plus
/// 0.01 mm. Of these, it takes the one whose axis is nearest to the position's axis. So an inserted position that was
/// shifted but not tilted gets the axis from which it came. Moves that are at most 2 mm of the path apart form one run.
///
/// Requires as many origins as moves, or none; without origins nothing is tilted.
/// Cost     One pass over the moves; chords to 0.01 mm for programmed curves into which positions were inserted.
[[nodiscard]] AxisTilts find_axis_tilts(const Toolpath& before, const Toolpath& after,
                                        const std::vector<std::size_t>& origins, std::size_t max_runs = 12);

/// Returns, for each move of a corrected path, the programmed unit axis at its end, as defined at find_axis_tilts.
/// Requires one origin for each move of `after`.
[[nodiscard]] std::vector<Vec3> programmed_axes(const Toolpath& before, const Toolpath& after,
                                                const std::vector<std::size_t>& origins);

}  // namespace gouge
