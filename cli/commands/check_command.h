#pragma once

#include <optional>
#include <string>

#include "cli/job/job_context.h"
#include "cli/options/job_options.h"

namespace gouge {

struct CheckArguments {
  JobArguments job;
  bool finds_cures = false;
  bool compares_laws = false;
  bool finds_stickout = false;
  std::string stickout_step = "1", stickout_limit = "200";
};

/// Returns the option rows of `check` that are not in job_options().
[[nodiscard]] const OptionRows<CheckArguments>& check_options();

void add_check_options(CLI::App& command, CheckArguments& arguments);

/// Finds the first value that its option does not allow, before any input is read. Code: usage.
[[nodiscard]] std::optional<Diagnostic> find_wrong_value(const CheckArguments& arguments);

/// Runs `gougecheck check`. Returns the exit status.
[[nodiscard]] int run_check(const CheckArguments& arguments, const JobContext& context);

}  // namespace gouge
