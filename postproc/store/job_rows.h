#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "postproc/batch/job_result.h"
#include "postproc/store/database.h"

// Results of jobs as rows of a store's tables, and back.

namespace gouge {

/// Requires that the store has no row of `job`.
void insert_job(Database& database, std::int64_t job, const JobResult& result);

/// Fills in those of `jobs` that have a result. The map `places` states which of them a job of that number is; rows of
/// other jobs are passed over. A result whose rows are not those that were inserted is_altered.
void read_jobs(Database& database, const std::map<std::int64_t, std::size_t>& places, std::vector<JobResult>& jobs);

}  // namespace gouge
