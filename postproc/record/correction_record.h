#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "lib/check/verdict.h"
#include "lib/correct/correct_path.h"
#include "lib/geom/vec.h"
#include "postproc/cldata/rewriting/list_written.h"

// The section "correction" of a result: the changes, the findings that are left, and the smoothness of the tool axis.
// Moves and lines are those of the path before the correction, unless a comment names the corrected path.

namespace gouge {

/// The gouge that is the cause of a change.
struct CauseRecord {
  std::size_t move = 0, line = 0;
  MoveState state = MoveState::gouge;
  double depth_mm = 0;
  Body body = Body::cutter;
  std::optional<Against> against;   ///< none: the tool is buried, and no surface is named
  std::optional<std::string> mesh;  ///< none: the tool is buried, and no mesh is named
};

/// A position of the toolpath that was changed or added.
struct CorrectedRecord {
  std::size_t move = 0;
  std::size_t line = 0;
  std::string strategy;      ///< "weighted", "axis", "tilt" or "trim"; "inserted" for a position inserted for a shift
  bool is_inserted = false;  ///< a position between programmed ones; false: a programmed one
  Vec3 shift_mm = Vec3::Zero();
  double shift_length_mm = 0;
  double tilt_rad = 0;
  double depth_before_mm = 0, depth_after_mm = 0;
  int iterations = 0;
  std::optional<CauseRecord> cause = {};
  /// The bytes in both files. None if another change has these bytes already, if there were none before (inserted
  /// position), and for binary files.
  std::optional<std::string> old_record = {}, new_record = {};

  /// Returns whether the position is above a stretch that is left out, or on the way to it.
  [[nodiscard]] bool is_uncut() const { return strategy == "trim"; }
};

/// The largest angle of a set of moves.
struct AngleRecord {
  double rad = 0;  ///< relative to mm to the power that the field states
  std::optional<std::size_t> move, line;
};

/// AxisQuality in the form of the file.
struct AxisQualityRecord {
  AngleRecord turn_per_mm, turn;
  std::size_t turns_on_the_spot = 0;
  AngleRecord turn_on_the_spot;
  double bending_per_mm3 = 0;
  std::optional<double> feed_seconds, limited_feed_seconds;  ///< none: the time is not finite
  std::size_t moves_without_feed = 0;
};

struct PositionCounts {
  std::size_t moved = 0, inserted = 0, tilted = 0;
};

/// Smoothness of the tool axis before and after the correction.
struct QualityRecord {
  AxisQualityRecord before, after;  ///< moves of `after` are those of the corrected path
  std::optional<double> max_rotary_deg_per_min;
  AngleRecord largest_tilt;  ///< in the corrected path
  PositionCounts positions;
  std::size_t tilted_runs = 0;
};

/// Arcs and splines that became straight moves.
struct StraightenedRecord {
  std::size_t curves = 0, straight_moves = 0;
};

struct UncutSumRecord {
  std::size_t positions = 0;
  double length_mm = 0;
  std::size_t holes = 0;
  std::vector<Uncut> stretches;
};

struct CorrectionRecord {
  std::string output_file;  ///< empty: no file was written
  std::string strategy;     ///< as requested
  std::optional<double> max_shift_mm, max_side_shift_mm;
  double rapid_clearance_mm = 0;
  std::optional<QualityRecord> quality;
  StraightenedRecord straightened;
  UncutSumRecord uncut;
  std::vector<StockStretch> stock;
  std::vector<LowRapid> low_rapids;
  std::vector<CorrectedRecord> changes;
  std::vector<Uncorrected> uncorrected;
  std::vector<WrittenStatement> written;
};

}  // namespace gouge
