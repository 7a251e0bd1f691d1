#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lib/motion/motion.h"
#include "lib/stock/cut_history.h"
#include "lib/stock/stock_head.h"
#include "lib/stock/stock_solid.h"
#include "lib/stock/tool_piece.h"

namespace gouge {

/// Moves that removed or touched the material of the last question. They are tried first in the next one.
struct StockHints {
  CutMove removed, touched;
};

/// The question about one move: which body is examined, and which material may still be there.
struct StockQuestion {
  const CutHistory& history;
  const StockSolid& stock;
  const StockOptions& options;
  const CompiledTool& body;  ///< the whole tool on a rapid, shank and holder otherwise
  std::size_t move = 0;
  std::uint64_t budget = 0;     ///< number of pieces after which the answer is open
  bool is_cutting = false;      ///< material that the cutter of this move removed before counts as gone
  bool is_clear_alone = false;  ///< the search ends at a deep point that no cut removed, and may miss a proof
  /// Null: nothing is kept. With hints an answer depends on the questions before it, through the order of the pieces.
  StockHints* hints = nullptr;
  /// Null: the body itself is examined. Else `body` is head->around(), and depths are those in the head at its turn. Requires
  /// motions with has_known_turn.
  const StockHead* head = nullptr;
};

/// A point of the stock that no tool touched before, inside a body.
struct StockWitness {
  double depth_mm = 0;
  double t = 0;               ///< instant of the move, in [0, 1]
  Vec3 point = Vec3::Zero();  ///< part coordinates, mm
};

/// The answer whether stock remains deeper in a body than a given depth.
struct StockAnswer {
  std::optional<StockWitness> witness;  ///< deeper than the given depth
  bool is_clear = false;                ///< proved: no stock is deeper than the given depth + resolution
  CutMove unknown;                      ///< a move whose unknown motion leaves open whether material is still there
  bool is_out_of_budget = false;        ///< open, because the budget ran out
  std::uint64_t examined = 0;           ///< number of pieces
};

/// Decides whether stock remains deeper than `depth_mm` in a body during [from, to] of a motion. It divides the body and
/// the time until each piece is free of stock, or a witness is found. Without either the answer is open: the budget ran
/// out, or a tool touched the material and may have removed it.
///
/// Shape    `pieces` contain all points of the body that are deeper (deep_pieces, or what an earlier proof left open).
/// Cost     About a microsecond for each question to the history.
/// Source   docs/method/stock.md.
[[nodiscard]] StockAnswer find_stock(const StockQuestion& question, const Motion& motion,
                                     const std::vector<ToolPiece>& pieces, double from, double to, double depth_mm);

/// A witness and an upper bound of the depth of all remaining stock.
struct StockDepth {
  StockWitness witness;
  double upper_mm = 0;
  std::uint64_t examined = 0;  ///< number of pieces
};

/// Asks about greater depths until both bounds of the depth are within depth_gap_mm, if the budget allows. The next depth
/// is twice the known one at most, since proofs for depths near the true one take longest.
/// Requires  `known` is a witness of the question, and no stock is deeper than `upper_mm`.
[[nodiscard]] StockDepth find_depth(const StockQuestion& question, const Motion& motion, const StockWitness& known,
                                    double upper_mm);

/// Returns the gap between the bounds of a depth at which the search ends.
[[nodiscard]] double depth_gap_mm(double depth_mm, const StockOptions& options);

/// Returns the body that contains a point: of the bare tool, or, for a point within a clearance only, of the tool that was
/// asked about.
[[nodiscard]] Body body_at(const CompiledTool& bare, const CompiledTool& asked, const Pose& pose, const Vec3& point);

}  // namespace gouge
