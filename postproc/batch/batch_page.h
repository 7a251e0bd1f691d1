#pragma once

#include <string>
#include <vector>

#include "postproc/batch/job_result.h"

namespace gouge {

/// Writes index.html of a batch: one row a job, the worst first. Rows are sortable by any column and filtered by a
/// word, and have the heat map and a link to the job's report. Needs no network; without scripts the table stands as it
/// is.
[[nodiscard]] std::string write_batch_page(const std::vector<JobResult>& jobs);

}  // namespace gouge
