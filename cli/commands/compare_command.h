#pragma once

#include <functional>
#include <iosfwd>
#include <string>

#include "cli/commands/program_reading.h"
#include "cli/terminal/print_diagnostics.h"
#include "lib/base/result.h"

namespace CLI {
class App;
}

namespace gouge {

struct CompareArguments : Verbosity, ProgramReading {
  std::string before, after;
  std::string same_within = "0.001";
  std::string html_file, json_file;  ///< "-": standard output, which then has nothing else
  bool are_paths = false;            ///< OLD and NEW are toolpaths
  ProgramReading of_new;             ///< facts of NEW alone
};

void add_compare_options(CLI::App& command, CompareArguments& arguments);

/// Runs `gougecheck compare`, which reports the changes from one result to another. Returns the exit status: 0 no gouge
/// is new or deeper, 1 some is, 2 wrong command line, 3 unreadable. Others are 4 something is no longer checked, 5
/// output unwritable.
[[nodiscard]] int run_compare(const CompareArguments& arguments, std::ostream& out, std::ostream& err);

/// Writes the comparison to the files of --html and --json, to all or to none. Only the texts that are needed are made.
/// Errors: file-unwritable, output-unwritable.
[[nodiscard]] Outcome write_comparison(const CompareArguments& arguments, const std::function<std::string()>& html,
                                       const std::function<std::string()>& json, std::ostream& out);

}  // namespace gouge
