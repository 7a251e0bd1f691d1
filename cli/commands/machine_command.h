#pragma once

#include <iosfwd>
#include <string>

#include "cli/machine/machine_choice.h"
#include "cli/options/reading_options.h"

namespace CLI {
class App;
}

namespace gouge {

struct MachineArguments {
  enum class Action { list, show, check, draw } action = Action::list;
  StatedMachine stated;
  std::string tool_length;  ///< of `check`, as typed
  std::string picture;      ///< of `draw`: a file
  InputLimit input;
};

void add_machine_commands(CLI::App& command, MachineArguments& arguments);

/// Runs `gougecheck machine list`, `show`, `check` and `draw`. Returns the exit status.
[[nodiscard]] int run_machine(const MachineArguments& arguments, std::ostream& out, std::ostream& err);

}  // namespace gouge
