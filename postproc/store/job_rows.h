#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "postproc/batch/job_result.h"
#include "postproc/store/database.h"

// Conversion of results of jobs to rows of a store's tables, and back.

namespace gouge {

/// Inserts the rows of a result. Requires that the store has no row of `job`.
void insert_job(Database& database, std::int64_t job, const JobResult& result);

/// Fills in those of `jobs` that have a result. `places` gives the index for the number of a job; rows of other jobs
/// are ignored. A result whose rows differ from the inserted ones is marked (is_altered).
void read_jobs(Database& database, const std::map<std::int64_t, std::size_t>& places, std::vector<JobResult>& jobs);

}  // namespace gouge
