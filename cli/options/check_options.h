#pragma once

#include <optional>
#include <string>

#include "cli/options/job_options.h"
#include "lib/stickout/find_stickout.h"

namespace gouge {

/// The options of `check`, as typed.
struct CheckArguments {
  JobArguments job;
  bool finds_cures = false;
  bool compares_laws = false;
  bool finds_stickout = false;
  std::string stickout_step = "1", stickout_limit = "200";
};

/// Returns the rows that `check` has beside job_options().
[[nodiscard]] const OptionRows<CheckArguments>& check_options();

void add_check_options(CLI::App& command, CheckArguments& arguments);

/// Adds those options of `check` that name neither its toolpath nor an output, to a command without a part of its own.
void add_options_of_checks(CLI::App& command, CheckArguments& arguments);

/// Finds the first value that its option does not allow, before any input is read. Code: usage.
[[nodiscard]] std::optional<Diagnostic> find_wrong_value(const CheckArguments& arguments);

/// Errors (code usage): names the option, the typed text and the expected one.
[[nodiscard]] Result<StickoutOptions> understand_stickout(const CheckArguments& arguments);

}  // namespace gouge
