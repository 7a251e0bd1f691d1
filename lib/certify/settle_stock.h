#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lib/check/check_result.h"
#include "lib/stock/cut_history.h"
#include "lib/stock/part_columns.h"
#include "lib/stock/stock_solid.h"

namespace gouge {

struct CheckSetup;

/// The question about material that the whole program leaves on the parts.
struct ExcessSetup {
  double asked_mm = 0;       ///< above 0
  PartColumns parts;         ///< in the order of Scene::parts
  bool is_pictured = false;  ///< the heights of the columns are kept for pictures
};

/// The stock of a check and the tools that cut it.
struct StockSetup {
  StockSolid solid;
  std::vector<StockTool> tools;  ///< one per Toolpath::tools, without offsets
  StockOptions options;
  std::optional<ExcessSetup> excess = {};  ///< none: material that is left on the parts is not asked for
};

/// Checks a path against its remaining stock and enters the result into its verdicts. A clean move that meets stock
/// becomes a gouge against the stock, and one for which that is open is not certified. The verdict of a move that gouges
/// a part or a fixture stays. If asked, enters the material that is left on the parts; it changes no verdict of a move.
///
/// Requires a verdict for each move. The events and counts of the result must be computed anew (summarise).
void settle_stock(const Toolpath& path, const CheckSetup& setup, CheckResult& result, const ProgressCall& progress);

}  // namespace gouge
