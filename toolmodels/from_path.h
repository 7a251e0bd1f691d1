#pragma once

#include <vector>

#include "lib/base/diagnostic.h"
#include "lib/base/result.h"
#include "lib/path/toolpath.h"
#include "toolmodels/assembly.h"

namespace gouge {

struct ToolFromPath {
  ToolAssembly tool;
  bool is_length_stated = true;  ///< false: its length is assumed
  Diagnostics notes;             ///< assumptions that were necessary
};

/// Makes a tool assembly from the statements of a toolpath, which `tool.cutter` must hold. CL data states no holder, so
/// `holder` (may be empty) is put on top, or at the stick-out that the path states. The part above the flutes is shank. A height that is missing is taken to be
/// the flute length. If that is missing too, or the height ends within the tip, it is replaced by max(5 d, 50 mm) and
/// reported. The default of APT, 5, would leave most of the tool out of the check.
///
/// Errors   Those of make_cutter_profile, with the name of the tool.
[[nodiscard]] Result<ToolFromPath> make_tool_from_path(const PathTool& tool, const std::vector<ToolSegment>& holder);

}  // namespace gouge
