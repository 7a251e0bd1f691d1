#pragma once

#include <vector>

#include "cli/batch/batch_list.h"
#include "cli/options/batch_options.h"
#include "postproc/report/sign_off.h"

namespace gouge {

/// Returns the head of the page of a batch: projects and reviewers of its jobs, the date, and the command that repeats
/// it. The command is the same for all shards of a list.
[[nodiscard]] SignOff batch_sign_off(const BatchArguments& arguments, const std::vector<BatchJob>& jobs);

}  // namespace gouge
