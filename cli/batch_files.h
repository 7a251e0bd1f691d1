#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "cli/report_folder.h"
#include "postproc/batch/job_result.h"

namespace gouge {

/// The store in the folder of a batch.
inline constexpr const char* kStoreName = "results.sqlite";

/// Writes index.html, summary.csv, summary.json, junit.xml and findings.sarif, all of them or none. Requires that
/// `folder` is open. Errors: those of ReportFolder.
[[nodiscard]] Outcome write_batch_files(ReportFolder& folder, const std::vector<JobResult>& results);

/// The table of the jobs; on a terminal its first rows.
void print_batch(std::ostream& out, const std::vector<JobResult>& results);

}  // namespace gouge
