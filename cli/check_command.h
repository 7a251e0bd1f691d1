#pragma once

#include <iosfwd>
#include <string>

#include "cli/job_options.h"

namespace gouge {

struct CheckArguments {
  JobArguments job;
  bool finds_cures = false;
  bool finds_stickout = false;
  std::string stickout_step = "1", stickout_limit = "200";
};

void add_check_options(CLI::App& command, CheckArguments& arguments);

/// `gougecheck check`. Returns the exit status.
[[nodiscard]] int run_check(const CheckArguments& arguments, std::ostream& out, std::ostream& err);

}  // namespace gouge
