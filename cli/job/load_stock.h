#pragma once

#include <deque>
#include <string>
#include <vector>

#include "cli/job/earlier_programs.h"
#include "cli/job/job.h"
#include "lib/certify/settle_stock.h"

namespace gouge {

/// The stock of a job with the meshes and tools to which it refers.
struct LoadedStock {
  std::deque<IndexedMesh> meshes;
  std::deque<ToolVariants> tools, tools_before, roomy_tools;
  std::optional<StockSetup> setup;

  LoadedStock() = default;
  LoadedStock(LoadedStock&&) = default;
  LoadedStock& operator=(LoadedStock&&) = default;
  LoadedStock(const LoadedStock&) = delete;
  LoadedStock& operator=(const LoadedStock&) = delete;
};

/// Makes the stock of a job, its tools without offsets, and the programs that cut it before. Adds their files to the inputs
/// of the job, and the fact that its verdict rests on the stock. The stock has the place and the unit of the parts.
/// Requires: find_wrong_stock finds nothing.
/// Nothing: `errors` has those of the files; a stock without an inside; a tool that cannot be made; a tolerance of the
/// control.
[[nodiscard]] std::optional<LoadedStock> load_stock(const JobArguments& arguments, Job& job, Progress& progress,
                                                    Diagnostics& errors);

/// Adds tools with which rapids keep a clearance from stock (StockSetup::roomy). A clearance of 0 adds none.
/// Errors: a tool that cannot be made.
[[nodiscard]] std::optional<Diagnostic> add_roomy_tools(double clearance_mm, const JobArguments& arguments,
                                                        const Job& job, LoadedStock& stock);

}  // namespace gouge
