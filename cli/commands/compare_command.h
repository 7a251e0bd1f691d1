#pragma once

#include <iosfwd>
#include <string>

#include "cli/commands/program_reading.h"
#include "cli/terminal/print_diagnostics.h"

namespace CLI {
class App;
}

namespace gouge {

struct CompareArguments : Verbosity, ProgramReading {
  std::string before, after;
  std::string same_within = "0.001";
  std::string html_file, json_file;  ///< "-": standard output, which then has nothing else
  bool are_paths = false;            ///< OLD and NEW are toolpaths
};

void add_compare_options(CLI::App& command, CompareArguments& arguments);

/// Runs `gougecheck compare`, which reports the changes from one result to another. Returns the exit status: 0 no gouge
/// is new or deeper, 1 some is, 2 wrong command line, 3 unreadable. Others are 4 something is no longer checked, 5
/// output unwritable.
[[nodiscard]] int run_compare(const CompareArguments& arguments, std::ostream& out, std::ostream& err);

}  // namespace gouge
