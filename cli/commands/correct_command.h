#pragma once

#include <optional>

#include "cli/job/job_context.h"
#include "cli/options/correct_options.h"

namespace gouge {

/// Finds the first value that its option does not allow, before any input is read. Code: usage.
[[nodiscard]] std::optional<Diagnostic> find_wrong_value(const CorrectArguments& arguments);

/// Runs `gougecheck correct`. Returns the exit status.
[[nodiscard]] int run_correct(const CorrectArguments& arguments, const JobContext& context);

}  // namespace gouge
