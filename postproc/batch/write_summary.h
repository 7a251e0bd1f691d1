#pragma once

#include <string>
#include <vector>

#include "postproc/batch/job_result.h"

// The files of a batch for programs: one row, object or suite for each job, in their order. Two runs of the same jobs
// may differ only in `seconds`, `memory_mb`, `host` and `rank`, and in JUnit's times.

namespace gouge {

/// docs/formats/batch.md names the columns. RFC 4180 with line feeds.
[[nodiscard]] std::string write_summary_csv(const std::vector<JobResult>& jobs);
[[nodiscard]] std::string write_summary_json(const std::vector<JobResult>& jobs);
/// Returns all findings as one run of SARIF; errors of jobs that failed are notifications of their invocation.
[[nodiscard]] std::string write_batch_sarif(const std::vector<JobResult>& jobs);
/// A suite for each job; one that failed has one case with an error, one that has not run a skipped one.
[[nodiscard]] std::string write_batch_junit(const std::vector<JobResult>& jobs);

}  // namespace gouge
