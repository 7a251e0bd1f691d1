#pragma once

#include <optional>
#include <set>
#include <string>

#include "lib/path/toolpath.h"
#include "tests/laws/motion_expander.h"

// Law: the moves that the product checks contain every motion that its file may mean.

namespace gouge::laws {

/// Nothing of the path is left unchecked: each move has no reason not to be, and a tool with a cutter, or one
/// of those that a tool library gives.
[[nodiscard]] bool is_wholly_checked(const Toolpath& path, const std::set<int>& library_tools, bool is_tool_given);

/// The first possible motion that no move of the path sweeps with its tool, in words; nothing: all are swept.
[[nodiscard]] std::optional<std::string> first_not_swept(const Expansion& expansion, const Toolpath& path);

}  // namespace gouge::laws
