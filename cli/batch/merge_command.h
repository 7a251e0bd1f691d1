#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "cli/terminal/print_diagnostics.h"

namespace gouge {

struct MergeArguments : Verbosity {
  std::vector<std::string> shards;
  std::string folder;
  bool is_forced = false;
};

void add_merge_options(CLI::App& command, MergeArguments& arguments);

/// Runs `gougecheck merge`. Returns the exit status: that of the worst job.
[[nodiscard]] int run_merge(const MergeArguments& arguments, std::ostream& out, std::ostream& err);

}  // namespace gouge
