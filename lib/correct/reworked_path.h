#pragma once

#include <vector>

#include "lib/correct/correct_path.h"

namespace gouge {

/// A path some moves of which became others: curves became chords, straight moves were tilted and cut into pieces.
struct ReworkedPath {
  Toolpath path;                    ///< moves, arcs and splines only; no source
  std::vector<std::size_t> origin;  ///< of each of its moves: which move of the path as it was. They do not fall.
  std::vector<bool> is_tilted;      ///< of each of its moves: it is not on the path as it was
  CheckResult result;               ///< verdicts of its moves; no events

  /// One more move.
  void add(const Move& move, std::size_t from, bool tilted, const MoveVerdict& verdict);
};

[[nodiscard]] bool is_curve(const Move& move);

/// What a reworked path has of a path, but for the moves.
[[nodiscard]] Toolpath without_moves(const Toolpath& path);

/// The changes of a reworked path, its own included, as changes of the path as it was.
[[nodiscard]] Correction restore_moves(const ReworkedPath& reworked, const Toolpath& path, const CheckResult& result,
                                       Correction correction);

}  // namespace gouge
