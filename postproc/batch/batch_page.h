#pragma once

#include <string>
#include <vector>

#include "postproc/batch/job_result.h"

namespace gouge {

/// Returns index.html of a batch: one row for each job, the worst first. Rows can be sorted by any column and filtered
/// by a word. They have the heat map and a link to the job's report. The page needs no network; without scripts the
/// table is static.
[[nodiscard]] std::string write_batch_page(const std::vector<JobResult>& jobs);

}  // namespace gouge
