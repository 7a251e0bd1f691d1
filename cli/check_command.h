#pragma once

#include <iosfwd>

#include "cli/job_options.h"

namespace gouge {

void add_check_options(CLI::App& command, JobArguments& arguments);

/// `gougecheck check`. Returns the exit status.
[[nodiscard]] int run_check(const JobArguments& arguments, std::ostream& out, std::ostream& err);

}  // namespace gouge
