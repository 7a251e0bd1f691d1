#pragma once

#include <iosfwd>
#include <vector>

#include "cli/options/batch_options.h"
#include "postproc/batch/job_result.h"

namespace gouge {

/// The end of one run of a batch.
struct BatchEnd {
  int status = 0;
  bool is_done = false;  ///< the jobs have run, with any outcome, and their results are written
  bool is_busy = false;  ///< nothing was done because another program has the folder or its store open
  std::vector<JobResult> results;
};

/// Runs that a watch makes. The watch holds the ReportLock of the folder.
enum class WatchRun { none, first, later };

/// Runs the jobs of a batch once. Errors are printed.
[[nodiscard]] BatchEnd run_batch_once(const BatchArguments& arguments, WatchRun of_watch, std::ostream& out,
                                      std::ostream& err);

}  // namespace gouge
