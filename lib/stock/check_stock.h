#pragma once

#include <vector>

#include "lib/base/parallel.h"
#include "lib/stock/cut_history.h"
#include "lib/stock/stock_search.h"
#include "lib/stock/stock_solid.h"

namespace gouge {

/// When a tool first meets remaining stock.
struct FirstContact {
  double clear_until = 0;  ///< proved: no stock is deeper than tolerance + resolution before this instant, in [0, 1]
  double contact_at = 0;   ///< at this instant a witness is deeper than the tolerance
};

/// The result for one move that is not clear of remaining stock.
struct StockFinding {
  std::size_t move = 0;
  std::optional<StockWitness> witness;  ///< none: the move is not certified
  double depth_upper_mm = 0;            ///< no remaining stock is deeper
  Body body = Body::cutter;             ///< body in which the witness is; head: a head leaves the move open
  std::size_t head = kNone;             ///< with Body::head: its index among those of the history
  FirstContact contact;                 ///< with a witness
  std::optional<PassedBy> nearest_cut;  ///< with a witness: the earlier cutter that came nearest to it
  CutMove unknown;                      ///< without a witness: the move whose unknown motion leaves it open
};

/// The result for a path. Moves that are in no finding are proved clear, except those with `is_examined` false.
struct StockResult {
  std::vector<StockFinding> findings;  ///< in path order
  std::vector<bool> is_examined;       ///< one for each move: its motion and its tool are known
  std::uint64_t proved = 0;            ///< number of moves that are clear
};

/// Checks every move of a path against the material that is still there: the whole tool on rapids, shank and holder on
/// all other moves, and the heads of the history on all moves. Material is gone once the cutter of an earlier cutting move was there, or that of the same move
/// earlier.
///
/// Shape    `tools[k]` belongs to path.tools[k], without offsets.
/// Requires options.tolerance_mm > 0, options.resolution_mm > 0.
/// Ensures  (1) A move without a finding has no remaining stock deeper than tolerance + resolution in its bodies, if
///          cutters count as wider and the stock as smaller by the resolution. (2) A finding with a depth has a witness:
///          a point of the stock that no tool touched before, at that depth. (3) The result is the same at any number of
///          threads.
/// Cost     The history takes about a microsecond and 100 bytes for each move, a clear move some microseconds.
/// Source   docs/method/stock.md.
[[nodiscard]] StockResult check_stock(const CutHistory& history, const StockSolid& stock, const StockOptions& options,
                                      unsigned threads, const ProgressCall& progress = {});

}  // namespace gouge
