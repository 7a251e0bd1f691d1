#pragma once

#include "cli/correct_options.h"
#include "cli/job_context.h"

namespace gouge {

/// `gougecheck correct`. Returns the exit status.
[[nodiscard]] int run_correct(const CorrectArguments& arguments, const JobContext& context);

}  // namespace gouge
