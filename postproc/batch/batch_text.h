#pragma once

#include <string>
#include <vector>

#include "postproc/batch/job_result.h"

namespace gouge {

/// Returns the text that `batch` prints: a table of its jobs, the worst first, the reason of each job that failed or is not
/// fully checked, and one line with their numbers. Names from outside are made printable. `most` is the maximum number of
/// rows; the number of omitted ones is stated. Reasons are broken at `columns`; 0: not at all.
[[nodiscard]] std::string batch_text(const std::vector<JobResult>& jobs, std::size_t most, std::size_t columns = 0);

/// Returns "0.213 mm at line 123", or nothing.
[[nodiscard]] std::string deepest_text(const JobResult& job);

}  // namespace gouge
