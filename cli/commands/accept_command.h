#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include "cli/commands/chosen_findings.h"
#include "cli/options/reading_options.h"

namespace CLI {
class App;
}

namespace gouge {

struct AcceptArguments {
  std::vector<std::string> results;
  std::vector<ChosenFinding> findings;   ///< to accept
  bool is_all = false;                   ///< every finding of every result; without numbers: list all findings
  std::vector<std::uint32_t> withdrawn;  ///< numbers of entries to remove from the only file
  std::string reason, by, date;          ///< an empty date means today
  std::string output;
  InputLimit input;
};

void add_accept_options(CLI::App& command, AcceptArguments& arguments);

/// Runs `gougecheck accept`, which adds findings of results to a file of accepted ones, or lists the findings. It also lists
/// the entries of such a file, and removes some. Returns the exit status: 0 done, 2 wrong command line, 3 unreadable or not acceptable, 5 output unwritable.
[[nodiscard]] int run_accept(const AcceptArguments& arguments, std::ostream& out, std::ostream& err);

}  // namespace gouge
