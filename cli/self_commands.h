#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace gouge {

/// Arguments of `help`, `man`, `completion` and `schema`, which print what the program states of itself.
struct SelfArguments {
  std::vector<std::string> command;  ///< of help and man: the words of a command
  std::string shell;                 ///< of completion
  std::string file_kind;             ///< of schema
};

void add_self_commands(CLI::App& app, SelfArguments& arguments);

/// Runs the one of them that `app` was called with, after its parse. Returns the exit status.
[[nodiscard]] int run_self_command(const CLI::App& app, const SelfArguments& arguments, std::ostream& out,
                                   std::ostream& err);

}  // namespace gouge
