#pragma once

#include <cstdint>
#include <iosfwd>

#include "cli/machine/machine_choice.h"

namespace gouge {

/// Runs `gougecheck machine check`: reads a machine and reports, for each law and kind of motion, whether it can be
/// used and which facts are missing; and doubts about the data. Returns the exit status: 0 if the laws in force can be
/// used, 4 if not.
[[nodiscard]] int check_machine(const StatedMachine& stated, std::uint64_t max_bytes, std::ostream& out,
                                std::ostream& err);

}  // namespace gouge
