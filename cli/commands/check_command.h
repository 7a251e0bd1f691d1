#pragma once

#include "cli/job/job_context.h"
#include "cli/options/check_options.h"

namespace gouge {

/// Runs `gougecheck check`. Returns the exit status.
[[nodiscard]] int run_check(const CheckArguments& arguments, const JobContext& context);

}  // namespace gouge
