#pragma once

#include <string>
#include <vector>

#include "cli/options/reading_options.h"
#include "lib/base/result.h"

namespace gouge {

/// A job in the summary of a batch.
struct ListedJob {
  std::string name, verdict;
  std::string result_file;  ///< empty: the job has no report
};

/// Returns the jobs of the batch in a folder, in their order.
/// Errors: result-format, result-syntax, and those of read_file.
[[nodiscard]] Result<std::vector<ListedJob>> read_batch_jobs(const std::string& folder, const InputLimit& limit);

/// Returns why a folder or file is not the folder of a batch that ended, with the remedy, as the rest of a sentence that
/// begins with its name.
[[nodiscard]] std::string describe_no_batch(const std::string& name);

}  // namespace gouge
