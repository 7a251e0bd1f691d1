#pragma once

#include <string>

#include "cli/options/job_options.h"
#include "postproc/result/stored_result.h"

namespace gouge {

/// Reads a result: the output of --json, or the folder of a report. Errors: those of read_file and read_result; usage, for
/// the folder of a batch.
[[nodiscard]] Result<StoredResult> load_result(const std::string& typed, const InputLimit& limit);

}  // namespace gouge
