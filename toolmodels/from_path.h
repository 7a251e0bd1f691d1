#pragma once

#include <vector>

#include "lib/base/diagnostic.h"
#include "lib/base/result.h"
#include "lib/path/toolpath.h"
#include "toolmodels/assembly.h"

namespace gouge {

struct ToolFromPath {
  ToolAssembly tool;
  Diagnostics notes;  ///< what had to be assumed
};

/// Makes a tool assembly from a toolpath's own words, which `tool.cutter` must hold. CL data knows no holder. The
/// `holder` (may be empty) is put on top, and the part above the flutes is shank. A height that is missing is the flute
/// length. Without one, or when it ends within the tip, it is replaced by max(5 d, 50 mm) and reported. APT's default
/// of 5 would leave most of the tool out of the check.
///
/// Errors   Those of make_cutter_profile, naming the tool.
[[nodiscard]] Result<ToolFromPath> make_tool_from_path(const PathTool& tool, const std::vector<ToolSegment>& holder);

}  // namespace gouge
