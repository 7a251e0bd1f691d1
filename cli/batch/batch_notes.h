#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "cli/batch/batch_job.h"
#include "postproc/store/result_store.h"

// Notes that a batch prints before its jobs run.

namespace gouge {

/// Notes that the baseline in the defaults of a list holds for its checks alone, if the list has corrections.
void note_left_baseline(const std::vector<BatchJob>& jobs, const std::string& list, std::ostream& err);

/// Notes how many jobs of an earlier batch in this folder have results that this batch replaces.
void note_replaced(ResultStore& store, const BatchIdentity& identity, const std::string& folder, std::ostream& err);

/// Prints that an earlier run ended while it ran the jobs `names`.
void note_running(const std::vector<std::string>& names, const std::string& folder, std::ostream& err);

}  // namespace gouge
