#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "cli/output/report_folder.h"
#include "postproc/batch/job_result.h"
#include "postproc/store/result_store.h"

namespace gouge {

/// The store in the folder of a batch.
inline constexpr const char* kStoreName = "results.sqlite";

/// Writes index.html, summary.csv, summary.json, junit.xml and findings.sarif, all of them or none. Requires that
/// `folder` is open. Errors: those of ReportFolder.
[[nodiscard]] Outcome write_batch_files(ReportFolder& folder, const std::vector<JobResult>& results);

/// The first of `files`, below `folder`, that is there though no job of the store wrote it as it is. In a batch that was
/// interrupted they are its own: it found none before it began. Code: report-foreign.
[[nodiscard]] std::optional<Diagnostic> find_foreign_output(const std::vector<std::string>& files,
                                                            const std::string& folder, const ResultStore& store);

/// The table of the jobs; on a terminal its first rows.
void print_batch(std::ostream& out, const std::vector<JobResult>& results);

/// The errors of jobs that came to no result, as their commands reported them: all that -q leaves.
void print_failures(std::ostream& err, const std::vector<JobResult>& results);

}  // namespace gouge
