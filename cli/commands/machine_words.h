#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "lib/machine/machine.h"

// Words of the commands about machines.

namespace gouge {

inline constexpr const char* kMachineExits =
    "Exit status: 0 done, 2 wrong command line, 3 input unreadable or invalid, 5 output unwritable.";

/// Returns a line with a name and its value.
[[nodiscard]] std::string machine_row(const std::string& name, const std::string& value);

/// Returns "joint A", or "joints A, B and C". Requires at least one index of Machine::joints.
[[nodiscard]] std::string joints_text(const Machine& machine, const std::vector<std::size_t>& joints);

}  // namespace gouge
