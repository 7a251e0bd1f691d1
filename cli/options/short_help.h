#pragma once

#include <string>

#include "cli/options/help_text.h"

namespace CLI {
class App;
}

namespace gouge {

/// Returns the page of --help for a command with many options: its usual ones, a line for each, in at most 30 lines of 80
/// columns. On a narrower terminal the lines are wrapped. Empty for a command whose whole help is short. `gougecheck help
/// COMMAND --all` prints all options.
[[nodiscard]] std::string short_help(const CLI::App& command, const HelpColumns& columns = HelpColumns());

}  // namespace gouge
