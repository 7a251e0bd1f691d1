#pragma once

#include <vector>

#include "lib/certify/motion_checker.h"
#include "lib/correct/correct_path.h"

namespace gouge {

/// A path in which some moves were replaced. Curves became chords. Straight moves were tilted, left out, or cut into
/// pieces.
struct ReworkedPath {
  Toolpath path;                    ///< only moves, arcs and splines; no source text
  std::vector<std::size_t> origin;  ///< for each of its moves, the move of the original path; ascending
  std::vector<bool> is_moved;       ///< for each of its moves: it is not on the original path
  CheckResult result;               ///< verdicts of its moves, without events

  /// Adds one move.
  void add(const Move& move, std::size_t from, bool moved, const MoveVerdict& verdict);
};

/// A position to which a straight move goes, in place of its end or on the way to it.
struct NewPosition {
  std::size_t move = 0;
  bool is_end = true;  ///< it is the last position of its move and replaces its end
  Pose pose;
  MoveKind kind = MoveKind::feed;  ///< kind of the motion to it
};

/// Returns a path in which `positions`, in path order, replace the ends of their moves.
///
/// If `base` is given, the path was reworked before, and `positions` refer to the moves of `base`. If it is null, they
/// refer to `path`.
/// Ensures  Every move that differs from the base is checked by itself.
[[nodiscard]] ReworkedPath with_positions(const Toolpath& path, const CheckResult& result, const ReworkedPath* base,
                                          const std::vector<NewPosition>& positions,
                                          const std::vector<const ToolVariants*>& tools, const MotionChecker& checker);

[[nodiscard]] bool is_curve(const Move& move);

/// Returns a path with everything except its moves and its source.
[[nodiscard]] Toolpath without_moves(const Toolpath& path);

/// Returns the changes of a reworked path, including its own rework, as changes of the original path.
[[nodiscard]] Correction restore_moves(const ReworkedPath& reworked, const Toolpath& path, const CheckResult& result,
                                       Correction correction);

}  // namespace gouge
