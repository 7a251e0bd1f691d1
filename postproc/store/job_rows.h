#pragma once

#include <cstdint>
#include <vector>

#include "postproc/batch/job_result.h"
#include "postproc/store/database.h"

// Results of jobs as rows of a store's tables, and back.

namespace gouge {

/// Requires that the store has no row of `job`.
void insert_job(Database& database, std::int64_t job, const JobResult& result);

/// Fills in those of `jobs`, counted from 0, that have a result. Rows of other jobs are passed over.
void read_jobs(Database& database, std::vector<JobResult>& jobs);

}  // namespace gouge
