#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lib/base/result.h"
#include "lib/path/toolpath.h"
#include "postproc/report/report_model.h"
#include "toolmodels/tool_library.h"

namespace gouge {

/// The resolved tools of a toolpath.
struct ResolvedTools {
  std::vector<std::optional<ToolAssembly>> assemblies;  ///< one per Toolpath::tools
  std::vector<ToolFacts> facts;
  Diagnostics notes;
  Assumptions assumptions;  ///< the tool and the holder of each tool that has moves
};

/// Finds each tool of the path. It is the one that `--tool N=NAME` names, else the library's of its number, else of its
/// name. Else it is the tool that CUTTER or TLDATA in the path states. NAME may be a number of the library, 3 or T3. A
/// tool of `--tool NAME` must be in the library; the option is otherwise ReadOptions::unnamed_tool. The `holder` is put
/// on tools that have none.
///
/// A tool of the library that is smaller anywhere than the path's own definition of it contradicts that. So does a name
/// that is of another tool of the library, or a --tool for numbers none of which the path loads.
/// Errors   (1) usage: a --tool or --holder that names nothing. (2) Those of make_profile for a tool of the path.
[[nodiscard]] Result<ResolvedTools> resolve_tools(const Toolpath& path, const ToolLibrary* library,
                                                  const std::vector<std::string>& tool_names,
                                                  const std::string& holder);

/// Returns the same where every tool of the path is `tool`.
[[nodiscard]] Result<ResolvedTools> resolve_given(const Toolpath& path, const ToolAssembly& tool);

}  // namespace gouge
