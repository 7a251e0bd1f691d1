#pragma once

#include <string>

#include "lib/tool/compiled_tool.h"

namespace gouge {

/// Returns a small side view of a tool as SVG for a page: the tip below, each body in the colour of the 3D view.
/// `label` is its description for readers of the page without pictures. Empty if the tool has no outline.
[[nodiscard]] std::string tool_drawing(const CompiledTool& tool, const std::string& label);

}  // namespace gouge
