#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace gouge {

/// Arguments of `help`, `man`, `completion` and `schema`, which print information about the program.
struct SelfArguments {
  std::vector<std::string> command;  ///< for help and man: the words of a command
  std::string shell;                 ///< for completion
  std::string file_kind;             ///< for schema
};

void add_self_commands(CLI::App& app, SelfArguments& arguments);

/// Runs the one of these commands with which `app` was called, after its parse. Returns the exit status.
[[nodiscard]] int run_self_command(const CLI::App& app, const SelfArguments& arguments, std::ostream& out,
                                   std::ostream& err);

}  // namespace gouge
