#include "cli/tools/stock_tools.h"

#include <utility>

#include "toolmodels/compile_tool.h"

namespace gouge {

Result<std::vector<StockTool>> make_stock_tools(const std::vector<std::optional<ToolAssembly>>& assemblies,
                                                std::deque<ToolVariants>& kept) {
  std::vector<StockTool> tools;
  for (const std::optional<ToolAssembly>& assembly : assemblies) {
    tools.emplace_back();
    if (!assembly) continue;
    Result<ToolVariants> variants = make_tool_variants(*assembly, 0, 0, 0);
    if (!variants) return variants.error();
    kept.push_back(std::move(*variants));
    tools.back() = {&kept.back(), assembly->cuts};
  }
  return tools;
}

Assumptions facts_of_program(const std::string& name, Assumptions facts) {
  for (Assumption& fact : facts) fact.object += (fact.object.empty() ? "" : " of ") + name;
  return facts;
}

}  // namespace gouge
