#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "lib/path/path_change.h"
#include "tests/postproc/report/small_report.h"

// A report of a correction that tilts the axes of one stretch of a curved finishing pass, for the writers' tests.

namespace gouge {

struct TiltedReport : SmallReport {
  static constexpr std::size_t kMoves = 121;
  static constexpr double kTilt_rad = 12 * std::numbers::pi / 180;

  Toolpath before;

  TiltedReport() {
    add_correction();
    before = path;
    before.moves.clear();
    for (std::size_t i = 0; i < kMoves; ++i) before.moves.push_back(programmed(i));
    path.moves = before.moves;
    for (const PathChange& change : tilting_changes()) path.moves[change.move].end = *change.new_end;
    result.verdicts.resize(kMoves);
    model.correction.toolpath_before = &before;
    measure();
  }

  void measure() {
    constexpr double kRadPerSecond = std::numbers::pi / 180 / 60;
    std::vector<std::size_t> origins;
    for (std::size_t i = 0; i < path.moves.size(); ++i) origins.push_back(i);
    AxisFacts axes;
    axes.max_rotary_deg_per_min = 600;
    axes.before = measure_axis_quality(before, 600 * kRadPerSecond);
    axes.after = measure_axis_quality(path, 600 * kRadPerSecond);
    axes.tilts = find_axis_tilts(before, path, origins);
    model.correction.axes = axes;
  }

  /// Positions 40 to 80 lean aside, as far as 12 degrees, and forward by half as much behind the middle.
  [[nodiscard]] std::vector<PathChange> tilting_changes() const {
    std::vector<PathChange> changes;
    for (std::size_t i = 40; i <= 80; ++i) {
      const double share = (static_cast<double>(i) - 40) / 40;
      const double side = kTilt_rad * std::pow(std::sin(share * std::numbers::pi), 2);
      const double lead = share > 0.5 ? 0.5 * kTilt_rad * std::sin((share - 0.5) * 2 * std::numbers::pi) : 0.0;
      Pose end = before.moves[i].end;
      const Vec3 forward = (before.moves[i + 1].end.tip - before.moves[i - 1].end.tip).normalized();
      const Vec3 left = end.axis.cross(forward);
      end.axis = (end.axis + std::tan(side) * left + std::tan(lead) * forward).normalized();
      PathChange change;
      change.move = i;
      change.new_end = end;
      changes.push_back(change);
    }
    return changes;
  }

  /// A wave of 1 mm steps whose axis leans forward by 4 degrees, more or less.
  [[nodiscard]] static Move programmed(std::size_t i) {
    const double x = static_cast<double>(i);
    const double lean = (4 + 1.5 * std::sin(x / 25)) * std::numbers::pi / 180;
    Move move;
    move.end = {Vec3(x, 6 * std::sin(x / 20), 0), Vec3(std::sin(lean), 0, std::cos(lean))};
    move.has_start = i > 0;
    move.set_feed({1500, FeedUnit::per_minute});
    move.line = 10 + i;
    move.tool = 0;
    return move;
  }
};

}  // namespace gouge
