#pragma once

#include <string>
#include <vector>

#include "cli/batch/batch_job.h"
#include "cli/batch/batch_list.h"
#include "cli/options/batch_options.h"
#include "postproc/store/result_store.h"

namespace gouge {

/// Returns the identity of a batch, by which a store knows its results again: the program, the list, and the jobs of the
/// shard. `texts`: takes the job_text of each job.
[[nodiscard]] BatchIdentity identify_batch(const BatchArguments& arguments, const std::vector<BatchJob>& jobs,
                                           const Shard& shard, std::vector<std::string>& texts);

}  // namespace gouge
