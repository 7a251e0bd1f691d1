#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "lib/base/result.h"
#include "lib/path/assumption.h"
#include "lib/stock/cut_history.h"
#include "toolmodels/assembly.h"

namespace gouge {

/// Makes the tools that cut stock: cutters and bodies as they are, since clearances and the stock to leave concern the
/// part. `kept` takes the compiled tools, to which the result points. A tool without a definition stays without one.
/// Errors: those of make_tool_variants.
[[nodiscard]] Result<std::vector<StockTool>> make_stock_tools(
    const std::vector<std::optional<ToolAssembly>>& assemblies, std::deque<ToolVariants>& kept);

/// Returns the facts about an earlier program. Their objects carry its name, since the path has facts of the same
/// subjects.
[[nodiscard]] Assumptions facts_of_program(const std::string& name, Assumptions facts);

}  // namespace gouge
