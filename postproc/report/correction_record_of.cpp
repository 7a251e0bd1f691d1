#include <cmath>

#include "postproc/report/record_of.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

AngleRecord angle_of(const LargestOfMoves& largest, const Toolpath& path) {
  AngleRecord record;
  record.rad = largest.value;
  if (largest.move != kNone) record.move = largest.move;
  if (largest.move < path.moves.size()) record.line = path.moves[largest.move].line;
  return record;
}

/// Returns the time, or none if it is not finite because a feed is almost 0.
std::optional<double> seconds_of(const std::optional<double>& time) {
  return time && std::isfinite(*time) ? time : std::nullopt;
}

AxisQualityRecord axis_quality_of(const AxisQuality& q, const Toolpath& path) {
  AxisQualityRecord record;
  record.turn_per_mm = angle_of(q.turn_rad_per_mm, path);
  record.turn = angle_of(q.turn_rad, path);
  record.turns_on_the_spot = q.turns_on_the_spot;
  record.turn_on_the_spot = angle_of(q.turn_on_the_spot_rad, path);
  record.bending_per_mm3 = q.bending;
  record.feed_seconds = seconds_of(q.feed_seconds);
  record.limited_feed_seconds = seconds_of(q.limited_feed_seconds);
  record.moves_without_feed = q.moves_without_feed;
  return record;
}

std::optional<QualityRecord> quality_of(const ReportModel& model) {
  const CorrectionFacts& c = model.correction;
  if (!c.axes) return std::nullopt;
  const Toolpath& before = c.toolpath_before != nullptr ? *c.toolpath_before : *model.toolpath;
  const AxisTilts& tilts = c.axes->tilts;
  QualityRecord record;
  record.before = axis_quality_of(c.axes->before, before);
  record.after = axis_quality_of(c.axes->after, *model.toolpath);
  record.max_rotary_deg_per_min = c.axes->max_rotary_deg_per_min;
  record.largest_tilt = angle_of(tilts.tilt_rad, *model.toolpath);
  record.positions = {moved_positions(c), inserted_positions(c), tilts.positions};
  record.tilted_runs = tilts.runs.size() + tilts.runs_left_out;
  return record;
}

}  // namespace

std::optional<CorrectionRecord> correction_record_of(const ReportModel& model) {
  if (!model.has_correction) return std::nullopt;
  const CorrectionFacts& c = model.correction;
  CorrectionRecord record;
  record.output_file = c.output_file;
  record.strategy = c.strategy;
  if (c.max_shift_mm > 0) record.max_shift_mm = c.max_shift_mm;
  record.max_side_shift_mm = c.max_side_shift_mm;
  record.rapid_clearance_mm = c.rapid_clearance_mm;
  record.quality = quality_of(model);
  record.straightened = {c.curves, c.straight_moves};
  const UncutTotal uncut = uncut_total(c);
  record.uncut = {uncut.positions, uncut.length_mm, uncut.holes, c.uncut};
  record.stock = c.stock;
  record.low_rapids = c.low_rapids;
  record.changes = c.changes;
  record.uncorrected = c.uncorrected;
  record.written = c.written;
  return record;
}

}  // namespace gouge
