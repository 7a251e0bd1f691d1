#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lib/path/assumption.h"
#include "lib/path/toolpath.h"
#include "toolmodels/assembly.h"

namespace gouge {

/// Returns the facts about heads on which a verdict rests: their turn about the tool axis, and their distance from the tip
/// of each tool that moves. The distance is the same for all tools. So it is right only if they are equally long.
///
/// `assemblies`: one for each of Toolpath::tools. The length of a tool is that to its gauge line, else that of cutter,
/// shank and holder together. LENGTH in the toolpath takes its place, and a stick-out in the toolpath changes it.
/// `machine`: its name; empty: none is given.
[[nodiscard]] Assumptions head_facts(const Toolpath& path, const std::vector<std::optional<ToolAssembly>>& assemblies,
                                     const std::string& machine);

}  // namespace gouge
