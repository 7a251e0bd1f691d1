#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/batch/batch_list.h"

namespace gouge {

/// Returns why these jobs cannot run together. An output of one job is an input or an output of another, or the job
/// list `list` (empty: there is none). Or it lies in the folder of the batch, but not at the place for this job. Or two
/// jobs read one pipe. Code: usage.
[[nodiscard]] std::optional<Diagnostic> find_jobs_in_the_way(const std::vector<BatchJob>& jobs,
                                                             const BatchFolder& folder, const std::string& list);

}  // namespace gouge
