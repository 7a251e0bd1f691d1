#pragma once

#include <string>

#include "lib/base/units.h"
#include "toolmodels/tool_library.h"

namespace gouge {

/// One line a tool under a heading, columns aligned, lengths in the library's unit.
[[nodiscard]] std::string tool_list_text(const ToolLibrary& library);

/// Every dimension of a tool, and the contour it makes. Requires a tool that make_profile accepts.
[[nodiscard]] std::string tool_text(const ToolAssembly& tool, LengthUnit unit);

}  // namespace gouge
