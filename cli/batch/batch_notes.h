#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "cli/batch/batch_job.h"
#include "postproc/store/result_store.h"

// Notes that a batch prints before its jobs run, and messages of its jobs.

namespace gouge {

/// Notes that the baseline in the defaults of a list holds for its checks alone, if the list has corrections.
void note_left_baseline(const std::vector<BatchJob>& jobs, const std::string& list, std::ostream& err);

/// Notes how many jobs of an earlier batch in this folder have results that this batch replaces.
void note_replaced(ResultStore& store, const BatchIdentity& identity, const std::string& folder, std::ostream& err);

/// Prints that an earlier run ended while it ran the jobs `names`.
void note_running(const std::vector<std::string>& names, const std::string& folder, std::ostream& err);

/// Prints messages of a job, each in a line that begins "job NAME: ".
void print_for_job(std::ostream& err, const std::string& job, const std::string& messages);

/// Prints the jobs with their options, and on `err` those of their inputs that do not exist. Returns whether there are any.
bool list_jobs_and_missing(const std::vector<const BatchJob*>& jobs, std::ostream& out, std::ostream& err);

}  // namespace gouge
