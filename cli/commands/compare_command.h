#pragma once

#include <iosfwd>
#include <string>

#include "cli/options/reading_options.h"
#include "cli/terminal/print_diagnostics.h"

namespace CLI {
class App;
}

namespace gouge {

struct CompareArguments : Verbosity {
  std::string before, after;
  std::string same_within = "0.001";
  std::string html_file, json_file;  ///< "-" writes to standard output alone
  InputLimit input;
};

void add_compare_options(CLI::App& command, CompareArguments& arguments);

/// Runs `gougecheck compare`, which reports what changed from one result to another. Returns the exit status: 0 nothing
/// is new or deeper, 1 something is, 2 wrong command line, 3 unreadable. Also 4 something was not checked any more, 5
/// output unwritable.
[[nodiscard]] int run_compare(const CompareArguments& arguments, std::ostream& out, std::ostream& err);

}  // namespace gouge
