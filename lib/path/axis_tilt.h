#pragma once

#include <cstddef>
#include <vector>

#include "lib/path/axis_quality.h"
#include "lib/path/toolpath.h"

// Measures the tilt of the axes of a corrected path from the programmed ones, position by position and along the path:
// docs/method/correction.md, "Quality".

namespace gouge {

/// Axes of one place of a corrected path. Both are measured from one direction for the whole run, the mean of its
/// programmed axes. The angle forward, towards the feed, is `lead`; `side` is the one to the left of the feed, seen
/// from the spindle. A plunge leads within some 17 degrees along that direction. It is seen in the forward direction of
/// the feed before it, or behind it.
struct TiltPlace {
  double length_mm = 0;  ///< of the corrected path from the begin of its run's curve
  double lead_before_rad = 0, side_before_rad = 0;
  double lead_after_rad = 0, side_after_rad = 0;
};

/// Neighbouring moves of the corrected path whose axes are not the programmed ones.
struct TiltedRun {
  std::size_t first = 0, last = 0;  ///< moves [first, last)
  LargestOfMoves tilt_rad;          ///< at the end of that move
  double begin_mm = 0, end_mm = 0;  ///< where they begin and end on the curve, between margins of programmed moves
  std::vector<TiltPlace> curve;     ///< two places of one length where the feed turns a corner
};

struct AxisTilts {
  LargestOfMoves tilt_rad;      ///< angle between corrected and programmed axis; the move is one of the corrected path
  std::size_t positions = 0;    ///< whose axes are not the programmed ones
  std::vector<TiltedRun> runs;  ///< the longest ones, in path order
  std::size_t runs_left_out = 0;  ///< shorter than those

  /// An axis is not the programmed one from here on: coarser than the digits of any file.
  static constexpr double kLeast_rad = 1e-3;
};

/// Finds the tilts of `after`. Its move k came of move `origins[k]` of `before`. The moves of one origin follow one
/// another. The last of them ends where that move ends, apart from the correction.
///
/// The programmed axis at the end of a move is that of the same move. For an inserted position it is that of the
/// programmed motion at its nearest place. Places count that are no further than twice the nearest one and 0.01 mm. Of
/// these the one is taken whose axis is nearest to the position's. So an inserted position that was shifted, and not
/// tilted, is found where it came from. Moves apart by up to 2 mm of the path are one run.
///
/// Requires as many origins as moves, or none: then nothing is tilted.
/// Cost     One pass over the moves; chords to 0.01 mm of programmed curves into which positions were inserted.
[[nodiscard]] AxisTilts find_axis_tilts(const Toolpath& before, const Toolpath& after,
                                        const std::vector<std::size_t>& origins, std::size_t max_runs = 12);

/// Returns for each move of a corrected path, the programmed unit axis at its end, as find_axis_tilts (axis_tilt.h)
/// states.
/// Requires one origin for each move of `after`.
[[nodiscard]] std::vector<Vec3> programmed_axes(const Toolpath& before, const Toolpath& after,
                                                const std::vector<std::size_t>& origins);

}  // namespace gouge
