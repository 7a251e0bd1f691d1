#pragma once

#include <cstddef>
#include <vector>

#include "lib/stock/stock_search.h"

namespace gouge {

/// Moves that follow each other with one tool and one kind of question.
struct MoveRange {
  std::size_t first = 0, last = 0;  ///< moves [first, last)
};

/// A move that a proof for its group left open, with the pieces of the body that are left.
struct OpenMove {
  std::size_t move = 0;
  std::vector<ToolPiece> pieces;  ///< cylinders
};

/// Proves for a group of moves together that no stock is left where a body passes. Moves for which the proof fails are
/// returned with their open pieces, in path order.
///
/// The body is held in its middle pose; all its places during the group are within a distance of it that grows with the
/// length of the group. Groups are divided into quarters until the distance is small beside the pieces. Only material
/// that was removed before the group counts as gone.
/// Requires  All moves have a known motion. `question.move` and `is_cutting` are those of the first move.
/// Source    The groups of lib/check/sweep_filter; docs/method/stock.md.
[[nodiscard]] std::vector<OpenMove> moves_not_clear(const StockQuestion& question, const MoveRange& range);

}  // namespace gouge
