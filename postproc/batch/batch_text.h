#pragma once

#include <string>
#include <vector>

#include "postproc/batch/job_result.h"

namespace gouge {

/// Returns the text that `batch` prints: a table of its jobs, the worst first, and one line with their numbers. Names
/// from outside are made printable. `most` is the maximum number of rows; the number of omitted ones is stated.
[[nodiscard]] std::string batch_text(const std::vector<JobResult>& jobs, std::size_t most);

/// Returns "0.213 mm at line 123", or nothing.
[[nodiscard]] std::string deepest_text(const JobResult& job);

}  // namespace gouge
