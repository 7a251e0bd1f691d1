#pragma once

#include <string>
#include <vector>

#include "lib/check/check_result.h"
#include "lib/stock/check_stock.h"
#include "lib/stock/cut_history.h"
#include "lib/stock/stock_solid.h"

namespace gouge {

struct CheckSetup;

/// The stock of a check and the tools that cut it.
struct StockSetup {
  StockSolid solid;
  std::vector<StockTool> tools;  ///< one per Toolpath::tools, without offsets
  StockOptions options;
  /// One per tool: the whole tool, wider in all directions, for corrections of rapids. Null or missing: not made.
  std::vector<const CompiledTool*> roomy = {};
  double roomy_mm = 0;  ///< by how much these are wider
};

/// Checks a path against its remaining stock and enters the result into its verdicts. A clean move that meets stock
/// becomes a gouge against the stock, and one for which that is open is not certified. The verdict of a move that gouges
/// a part or a fixture stays.
///
/// Requires a verdict for each move. The events and counts of the result must be computed anew (summarise).
/// Returns what was found for each move.
StockResult settle_stock(const Toolpath& path, const CheckSetup& setup, CheckResult& result,
                         const ProgressCall& progress);

/// Returns the cuts of a path. Requires setup.stock. All arguments must outlive the result.
[[nodiscard]] CutHistory cuts_of(const Toolpath& path, const CheckSetup& setup);

/// Returns the evidence for stock in a body of a tool.
[[nodiscard]] Witness stock_witness(const StockWitness& found, Body of, const CompiledTool& body, const Motion& motion);

}  // namespace gouge
