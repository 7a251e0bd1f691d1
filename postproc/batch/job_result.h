#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lib/base/file_search.h"
#include "postproc/report/findings.h"

namespace gouge {

/// A file that a job has written.
struct JobOutput {
  std::string file;  ///< relative to the folder of the batch, or as the job names it
  std::uint64_t bytes = 0;
  std::string sha256;

  bool operator==(const JobOutput&) const = default;
};

/// Result of one job of a batch. Lengths are in the unit of its toolpath.
struct JobResult {
  std::string name, command;
  std::string toolpath;           ///< name in the job
  std::optional<int> status;      ///< the exit status of its command; none: it has not run
  std::string unit;               ///< unit of the toolpath; empty: it could not be read
  StateCounts counts;             ///< of the moves
  std::optional<double> deepest;  ///< depth of the deepest gouge; none: there is no gouge
  double deepest_mm = 0;          ///< the same depth in mm
  std::size_t deepest_line = 0;   ///< its line in the toolpath
  std::vector<Finding> findings;
  std::vector<JunitCase> cases;
  std::string beside;  ///< notes and warnings besides the verdict, one in each line
  Diagnostics notes;   ///< notes and warnings; first those of contradicted facts, then those of other open facts
  std::vector<InputFile> inputs;
  SearchLog searches;  ///< for files that may be absent; those that were found are in `inputs` too
  std::vector<JobOutput> outputs;
  std::string report;    ///< its report.html relative to the folder of the batch; empty: none
  std::string key;       ///< SHA-256 of all data on which the result depends; empty: the result must not be used again
  std::string messages;  ///< text of its command on standard error
  bool is_altered = false;  ///< a store returned other rows than were stored: the result is not valid
  // Fields that may differ between two runs of the same job.
  double seconds = 0;
  double memory_mb = 0;  ///< peak memory of the process until the end of the job
  std::string host;
  int rank = 0;

  [[nodiscard]] std::size_t moves() const;
  /// Returns the number of its findings that are gouges or a buried tool.
  [[nodiscard]] std::size_t gouge_findings() const;
  /// Returns its warnings.
  [[nodiscard]] Diagnostics warnings() const;
  /// Returns its warnings as text; for a job without a result the errors that its command reported.
  [[nodiscard]] std::vector<std::string> remarks() const;
  /// Returns "clean", "accepted-gouges", "gouges", "material-left", "not-fully-checked", "failed" or "not-run".
  [[nodiscard]] const char* verdict() const;
};

/// Returns the rank of an exit status, from the worst: 5, 2, 3, 1, 4, 0. A job that has not run counts as 4.
[[nodiscard]] int severity_of(std::optional<int> status);

/// Returns the exit status of a batch: that of its worst job.
[[nodiscard]] int batch_status(const std::vector<JobResult>& jobs);

/// Returns the indices of `jobs`, the worst first: by status, then by depth, then in their order.
[[nodiscard]] std::vector<std::size_t> worst_first(const std::vector<JobResult>& jobs);

/// Returns the number of jobs with each verdict: "3 clean, 2 gouges, 1 failed".
[[nodiscard]] std::string verdict_counts(const std::vector<JobResult>& jobs);

/// A file of which two jobs read different contents, or a search that found different files for two jobs.
struct TwoContents {
  std::string role, name;
  bool is_search = false;             ///< `name` is the place where both jobs looked for a file
  std::size_t first = 0, second = 0;  ///< indices of the jobs
};

/// Returns the first such file, else the first such search; none if every verdict holds for the same contents.
[[nodiscard]] std::optional<TwoContents> find_two_contents(const std::vector<JobResult>& jobs);

/// Copies into `result` all data of a report that a batch keeps.
void take_report(const ReportModel& model, JobResult& result);

}  // namespace gouge
