#pragma once

#include <string>
#include <vector>

#include "postproc/batch/job_result.h"

namespace gouge {

/// Returns index.html of a batch: one row for each job, the worst first. Rows can be sorted by any column and filtered
/// by a word. They have the heat map and a link to the job's report. A printed page has lines to sign. The page needs no
/// network; without scripts the table is static. Reports lead to one another through this page (batch_links).
[[nodiscard]] std::string write_batch_page(const std::vector<JobResult>& jobs, const SignOff& sign_off);

}  // namespace gouge
