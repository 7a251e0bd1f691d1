#pragma once

#include "lib/path/feed.h"
#include "lib/path/toolpath.h"

namespace gouge {

/// Returns whether the machine runs the move in rapid: also an arc in rapid, and a step of a cycle that positions.
[[nodiscard]] inline bool runs_rapid(const Move& move) {
  return move.kind == MoveKind::rapid || move.feed_unit == FeedUnit::rapid;
}

/// Returns whether a cutter removes the stock that it sweeps in the move: not in a rapid, and not with a stopped spindle.
[[nodiscard]] inline bool removes_stock(const Move& move) {
  return move.has_start && !runs_rapid(move) && !move.is_spindle_stopped();
}

/// Returns the kind by which the move runs and cuts: rapid where it runs in rapid, else its own.
[[nodiscard]] inline MoveKind run_kind(const Move& move) { return runs_rapid(move) ? MoveKind::rapid : move.kind; }

}  // namespace gouge
