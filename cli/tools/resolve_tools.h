#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/tools/compare_tools.h"
#include "lib/base/result.h"
#include "lib/path/toolpath.h"
#include "postproc/report/report_model.h"
#include "toolmodels/tool_library.h"

namespace gouge {

/// The resolved tools of a toolpath.
struct ResolvedTools {
  std::vector<std::optional<ToolAssembly>> assemblies;  ///< one for each of Toolpath::tools
  std::vector<ToolFacts> facts;
  Diagnostics notes;
  Assumptions assumptions;  ///< about the tool and the holder of each tool that has moves
};

/// Finds each tool of the path. It is the tool of `--tool N=NAME`, where N is its number or name. Else it is the one in
/// the library with its number, else the one with its name. Otherwise it is the tool that CUTTER or TLDATA in the path
/// states. NAME may be a number of the library, 3 or T3. A tool of `--tool NAME` must be in the library; for other uses
/// of the option see ReadOptions::unnamed_tool. The `holder` is put on tools that have none.
///
/// The tool is contradicted if the one of the library is anywhere smaller than the definition in the path. A tool that
/// removes stock is also contradicted if it is anywhere larger. A name that belongs to another tool of the library
/// contradicts it too. So does --tool if it names only tools that the path does not load, or if its NAME alone is for
/// moves without a tool and there are none.
/// `length`: for compare_tools.
/// Errors   (1) usage: a --tool or --holder that names nothing. (2) Those of make_profile for a tool of the path.
[[nodiscard]] Result<ResolvedTools> resolve_tools(const Toolpath& path, const ToolLibrary* library,
                                                  const std::vector<std::string>& tool_names, const std::string& holder,
                                                  ToolUse use = ToolUse::finds_gouges, GaugeLength length = {});

/// Describes the error no-tool: no tool of the path is defined. `library`: the file of --tools; may be empty.
[[nodiscard]] Diagnostic describe_missing_tools(const Toolpath& path, const std::string& library);

/// Resolves a path in which `tool` takes the place of every tool.
[[nodiscard]] Result<ResolvedTools> resolve_given(const Toolpath& path, const ToolAssembly& tool,
                                                  ToolUse use = ToolUse::finds_gouges, GaugeLength length = {});

}  // namespace gouge
