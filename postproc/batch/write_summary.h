#pragma once

#include <string>
#include <vector>

#include "postproc/batch/job_result.h"

// The files of a batch for programs: one row, object or suite for each job, in the order of the jobs. Two runs of the
// same jobs may differ only in `seconds`, `memory_mb`, `host` and `rank`, and in the times in JUnit.

namespace gouge {

/// Returns the summary in the format of RFC 4180, but with line feeds. docs/formats/batch.md names the columns.
[[nodiscard]] std::string write_summary_csv(const std::vector<JobResult>& jobs);
[[nodiscard]] std::string write_summary_json(const std::vector<JobResult>& jobs);
/// Returns all findings as one run of SARIF; errors of jobs that failed are notifications of their invocation.
[[nodiscard]] std::string write_batch_sarif(const std::vector<JobResult>& jobs);
/// Returns a suite for each job. A failed job has one case with an error, and a job that has not run has a skipped
/// case.
[[nodiscard]] std::string write_batch_junit(const std::vector<JobResult>& jobs);

}  // namespace gouge
