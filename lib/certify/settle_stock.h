#pragma once

#include <deque>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lib/check/check_result.h"
#include "lib/head/head_body.h"
#include "lib/stock/check_stock.h"
#include "lib/stock/cut_history.h"
#include "lib/stock/part_columns.h"
#include "lib/stock/stock_head.h"
#include "lib/stock/stock_solid.h"

namespace gouge {

struct CheckSetup;

/// The question about material that the whole program leaves on the parts.
struct ExcessSetup {
  double asked_mm = 0;       ///< above 0
  PartColumns parts;         ///< in the order of Scene::parts
  bool is_pictured = false;  ///< the heights of the columns are kept for pictures
};

/// A program that cut the stock before the path, in the coordinates of the path.
struct EarlierProgram {
  Toolpath path;
  MotionLaw law;
  std::vector<StockTool> tools;  ///< one per path.tools, without offsets
};

/// The stock of a check and the programs and tools that cut it.
struct StockSetup {
  StockSolid solid;
  std::deque<EarlierProgram> before = {};  ///< in the order in which they ran
  std::vector<StockTool> tools = {};       ///< one per Toolpath::tools, without offsets
  StockOptions options = {};
  std::vector<StockHead> heads = {};       ///< one per CheckSetup::heads
  std::optional<ExcessSetup> excess = {};  ///< none: material that is left on the parts is not asked for
  /// One per tool: the whole tool, wider in all directions, for corrections of rapids. Null or missing: not made.
  std::vector<const CompiledTool*> roomy = {};
  double roomy_mm = 0;  ///< by how much these are wider
};

/// The cuts of a path after those of the programs before it.
class StockHistory {
 public:
  /// All arguments must outlive it.
  StockHistory(const Toolpath& path, const MotionLaw& law, const StockSetup& stock);

  /// Returns the history of the path, which follows the others.
  [[nodiscard]] const CutHistory& of_path() const { return programs_.back(); }

 private:
  std::deque<CutHistory> programs_;
};

/// Returns the fact that a verdict rests on this stock and on the programs that cut it. `file`: of the path.
/// The fact is contradicted if a part is not in the stock, from which it is cut.
[[nodiscard]] Assumption assume_stock(const std::string& description, const StockSetup& stock,
                                      std::span<const IndexedMesh> parts, const std::string& file);

/// Checks a path against its remaining stock and enters the result into its verdicts. A clean move that meets stock
/// becomes a gouge against the stock, and one for which that is open is not certified. A move that gouges a part or a
/// fixture keeps its verdict, with a remark about the stock (Reason::is_stock_too). If asked, enters the material that is
/// left on the parts; it changes no verdict of a move.
///
/// Requires a verdict for each move. The events and counts of the result must be computed anew (summarise).
/// Returns what was found for each move.
StockResult settle_stock(const Toolpath& path, const CheckSetup& setup, CheckResult& result,
                         const ProgressCall& progress);

/// Returns the heads of a check for its stock, which refer to them.
[[nodiscard]] std::vector<StockHead> stock_heads(const std::vector<HeadBody>& heads);

/// Returns the evidence for stock in a body of a tool.
[[nodiscard]] Witness stock_witness(const StockWitness& found, Body of, const CompiledTool& body, const Motion& motion);
/// Returns the evidence for stock in a head.
[[nodiscard]] Witness stock_witness(const StockWitness& found, const StockHead& head, const Motion& motion);

}  // namespace gouge
