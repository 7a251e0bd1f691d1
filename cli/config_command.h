#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace gouge {

void add_config_commands(CLI::App& app);

/// Runs `gougecheck config [check|correct] [OPTIONS]`, which lists the options in force for that command line in this
/// folder, with the origin of each. Returns the exit status.
[[nodiscard]] int run_config(const std::vector<std::string>& words, std::ostream& out, std::ostream& err);

/// Runs `gougecheck init [OPTIONS]`, which writes a project file from the files in the working directory. Given options
/// of check or correct take precedence. Never replaces an existing file. Returns the exit status.
[[nodiscard]] int run_init(const std::vector<std::string>& words, std::ostream& out, std::ostream& err);

}  // namespace gouge
