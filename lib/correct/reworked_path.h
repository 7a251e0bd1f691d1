#pragma once

#include <vector>

#include "lib/certify/motion_checker.h"
#include "lib/correct/correct_path.h"

namespace gouge {

/// A path in which some moves were replaced. Curves became chords; straight moves were tilted, left out, or cut into
/// pieces.
struct ReworkedPath {
  Toolpath path;                    ///< moves, arcs and splines only; no source
  std::vector<std::size_t> origin;  ///< of each of its moves: which move of the path as it was. They do not fall.
  std::vector<bool> is_moved;       ///< of each of its moves: it is not on the path as it was
  CheckResult result;               ///< verdicts of its moves; no events

  /// Adds one move.
  void add(const Move& move, std::size_t from, bool moved, const MoveVerdict& verdict);
};

/// A position that a straight move goes to: in place of its end, or on the way to it.
struct NewPosition {
  std::size_t move = 0;
  bool is_end = true;  ///< the last of its move, and in place of its end
  Pose pose;
  MoveKind kind = MoveKind::feed;  ///< how it is reached
};

/// Returns a path with `positions`, in path order, in place of what their moves were.
///
/// With `base` the path was reworked before, and `positions` are of the moves of `base`. With null they are of `path`
/// itself.
/// Ensures  Every move that is not as it was in the base is checked by itself.
[[nodiscard]] ReworkedPath with_positions(const Toolpath& path, const CheckResult& result, const ReworkedPath* base,
                                          const std::vector<NewPosition>& positions,
                                          const std::vector<const ToolVariants*>& tools, const MotionChecker& checker);

[[nodiscard]] bool is_curve(const Move& move);

/// Returns a reworked path without its moves.
[[nodiscard]] Toolpath without_moves(const Toolpath& path);

/// Returns the changes of a reworked path, its own included, as changes of the path as it was.
[[nodiscard]] Correction restore_moves(const ReworkedPath& reworked, const Toolpath& path, const CheckResult& result,
                                       Correction correction);

}  // namespace gouge
