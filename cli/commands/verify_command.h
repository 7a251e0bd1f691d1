#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>

#include "cli/options/reading_options.h"
#include "cli/terminal/print_diagnostics.h"

namespace CLI {
class App;
}

namespace gouge {

struct VerifyArguments : Verbosity {
  std::string result_file, certificate_file;
  InputLimit input;
  std::string seconds;  ///< empty: a fixed number of samples
  std::string progress = "auto";
  std::uint32_t threads = 0;
};

void add_verify_options(CLI::App& command, VerifyArguments& arguments);

/// Runs `gougecheck verify`, which tests whether a result is correct. Depths and findings share no code with the check except the
/// readers of files. Returns the exit status: 0 verified, 1 refuted, 2 wrong command line, 3 unreadable, 4 not
/// everything is covered.
[[nodiscard]] int run_verify(const VerifyArguments& arguments, std::ostream& out, std::ostream& err);

}  // namespace gouge
