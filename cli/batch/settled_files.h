#pragma once

#include <sys/types.h>
#include <cstdint>
#include <iosfwd>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cli/output/report_folder.h"
#include "postproc/batch/job_result.h"
#include "postproc/store/result_store.h"

namespace gouge {

/// Properties of a file that change when it is written.
struct FileStamp {
  std::int64_t time_ns = 0;
  off_t bytes = 0;

  bool operator==(const FileStamp&) const = default;
};
using FileStamps = std::map<std::string, FileStamp>;

/// The files of a folder, and which of them are no longer being written: neither size nor time has changed for a
/// second. Hidden and temporary ones (~, .tmp, .part, ...) are passed over.
class SettledFiles {
 public:
  /// `place`: a folder, or a pattern for the names in one.
  explicit SettledFiles(const std::string& place);

  [[nodiscard]] const std::string& folder() const { return folder_; }
  /// Returns whether `place` is a folder, and no pattern for the names in one.
  [[nodiscard]] bool is_whole_folder() const { return is_whole_folder_; }
  /// Examines the folder. The time `now_s` is of a clock that never goes back, whatever the times of the files are. A
  /// copy keeps the time of its original.
  [[nodiscard]] FileStamps look(double now_s);
  /// Returns whether the last look found some file that is yet to settle.
  [[nodiscard]] bool is_unsettled() const { return is_unsettled_; }

 private:
  struct Seen {
    FileStamp stamp;
    double since_s = 0;
  };

  std::string folder_, pattern_;
  std::map<std::string, Seen> seen_;
  bool is_unsettled_ = false, is_whole_folder_ = false;
};

/// The store in the folder of a batch.
inline constexpr const char* kStoreName = "results.sqlite";

/// Writes index.html, summary.csv, summary.json, junit.xml and findings.sarif, all of them or none. Requires that
/// `folder` is open. Errors: those of ReportFolder.
[[nodiscard]] Outcome write_batch_files(ReportFolder& folder, const std::vector<JobResult>& results);

/// Returns the first of `files`, below `folder`, that is there though no job of the store wrote it as it is. In a batch
/// that was interrupted they are its own: it found none before it began. Code: report-foreign.
[[nodiscard]] std::optional<Diagnostic> find_foreign_output(const std::vector<std::string>& files,
                                                            const std::string& folder, const ResultStore& store);

/// The table of the jobs; on a terminal its first rows.
void print_batch(std::ostream& out, const std::vector<JobResult>& results);

/// The errors of jobs that came to no result, as their commands reported them: all that -q leaves.
void print_failures(std::ostream& err, const std::vector<JobResult>& results);

}  // namespace gouge
