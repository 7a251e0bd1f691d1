#pragma once

#include <string>
#include <vector>

namespace gouge {

/// The group of options about programs of a machine's control.
inline constexpr const char* kProgramGroup = "Program";

/// Returns the values of --control.
[[nodiscard]] std::vector<std::string> control_ids();

}  // namespace gouge
