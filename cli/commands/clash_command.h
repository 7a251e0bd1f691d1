#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "cli/options/reading_options.h"
#include "cli/terminal/print_diagnostics.h"

namespace CLI {
class App;
}

namespace gouge {

struct ClashArguments : Verbosity {
  std::string a, b;
  InputLimit input;
  std::string stl_units = "mm";
  std::string place_b;  ///< empty: B stays where its file places it
  std::string tolerance = "0.01", resolution = "0.001";
  std::string json_file;                   ///< "-": standard output, which then has nothing else
  std::vector<std::string> lengths_in_mm;  ///< lengths typed without a unit (length_rule.h)
};

void add_clash_options(CLI::App& command, ClashArguments& arguments);

/// Runs `gougecheck clash`, which tests whether two bodies of a set-up penetrate. Returns the exit status: 0 proved
/// free or touching within the tolerance, 1 they penetrate, 2 wrong command line. Others are 3 unreadable, 4 not
/// certified, 5 output unwritable.
[[nodiscard]] int run_clash(const ClashArguments& arguments, std::ostream& out, std::ostream& err);

}  // namespace gouge
