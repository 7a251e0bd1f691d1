#pragma once

#include "cli/machine/joint_facts.h"
#include "cli/options/option_table.h"

namespace gouge {

/// Returns the rows of options that state facts of the joints of a machine.
[[nodiscard]] const OptionRows<StatedJoints>& joint_options();

/// Adds them to a command about a machine, as a group of their own.
void add_joint_options(CLI::App& command, StatedJoints& stated);

}  // namespace gouge
