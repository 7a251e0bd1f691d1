#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace gouge {

void add_config_commands(CLI::App& app);

/// Runs `gougecheck config [check|correct] [OPTIONS]`. It lists the options that hold for that command line in this
/// folder, and where each comes from. Returns the exit status.
[[nodiscard]] int run_config(const std::vector<std::string>& words, std::ostream& out, std::ostream& err);

/// Runs `gougecheck init [OPTIONS]`, which writes a project file from the files in the working directory; options of
/// check or correct that are given go before. Never over a file that exists. Returns the exit status.
[[nodiscard]] int run_init(const std::vector<std::string>& words, std::ostream& out, std::ostream& err);

}  // namespace gouge
