#pragma once

#include <sys/types.h>
#include <cstdint>
#include <iosfwd>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/batch/toolpath_files.h"
#include "cli/output/report_folder.h"
#include "postproc/batch/job_result.h"
#include "postproc/store/result_store.h"

namespace gouge {

/// Properties of a file that change when the file is written.
struct FileStamp {
  std::int64_t time_ns = 0;
  off_t bytes = 0;

  bool operator==(const FileStamp&) const = default;
};
using FileStamps = std::map<std::string, FileStamp>;

/// The files of a folder, and of those below it, that are no longer being written: their size and time have not changed
/// for a second. Hidden and temporary files (~, .tmp, .part, ...) are ignored.
class SettledFiles {
 public:
  /// `place` is a folder, or a pattern for the names in a folder, without those below it. The folder `output` is passed
  /// over.
  explicit SettledFiles(const std::string& place, std::string output = {});

  [[nodiscard]] const std::string& folder() const { return folder_; }
  /// Returns whether `place` is a folder, not a pattern.
  [[nodiscard]] bool is_whole_folder() const { return is_whole_folder_; }
  /// Examines the folders. The time `now_s` must come from a clock that never goes back. It is independent of the times
  /// of the files, as a copy keeps the time of its original.
  [[nodiscard]] FileStamps look(double now_s);
  /// Returns whether the last call of `look` found a file that is not settled yet.
  [[nodiscard]] bool is_unsettled() const { return is_unsettled_; }
  /// Returns the folders that the last call of `look` examined.
  [[nodiscard]] const std::vector<std::string>& folders() const { return found_.folders; }
  /// Returns the errors of the folders that it could not read.
  [[nodiscard]] const Diagnostics& unreadable() const { return found_.unreadable; }

 private:
  struct Seen {
    FileStamp stamp;
    double since_s = 0;
  };
  void look_into(const std::string& folder, double now_s, std::map<std::string, Seen>& now, FileStamps& settled) const;

  std::string folder_, pattern_, output_;
  FoldersFound found_;
  std::map<std::string, Seen> seen_;
  bool is_unsettled_ = false, is_whole_folder_ = false;
};

/// Files that are given by name, such as the part and the tools of all jobs. A missing file has no stamp.
class SettledInputs {
 public:
  SettledInputs(std::vector<std::string> files, double now_s);

  /// Replaces the names of the files. A file that is new here counts as changed.
  void set(std::vector<std::string> files) { files_ = std::move(files); }
  /// Returns the stamps of the files when none of them had changed for a second; at first those at the construction.
  [[nodiscard]] FileStamps look(double now_s);
  /// Returns whether a file has changed within the last second.
  [[nodiscard]] bool is_unsettled() const { return seen_ != settled_; }

 private:
  [[nodiscard]] FileStamps stamps() const;

  std::vector<std::string> files_;
  FileStamps seen_, settled_;
  double since_s_ = 0;
};

/// Name of the store in the folder of a batch.
inline constexpr const char* kStoreName = kBatchStoreName;

/// Writes index.html, summary.csv, summary.json, junit.xml and findings.sarif, all of them or none. Requires that
/// `folder` is open. Errors: those of ReportFolder.
[[nodiscard]] Outcome write_batch_files(ReportFolder& folder, const std::vector<JobResult>& results,
                                        const SignOff& sign_off);

/// Returns the first of `files`, below `folder`, that exists with other content than a job of the store wrote. In an
/// interrupted batch all of them are its own, because it found none before it began. Code: report-foreign.
[[nodiscard]] std::optional<Diagnostic> find_foreign_output(const std::vector<std::string>& files,
                                                            const std::string& folder, const ResultStore& store);

/// Prints the table of the jobs; on a terminal only its first rows.
void print_batch(std::ostream& out, const std::vector<JobResult>& results);

/// Prints the warnings and notes of the jobs that were checked, and the further messages of those that failed, with
/// `is_verbose`. Otherwise it prints the number of the warnings.
void print_job_notes(std::ostream& out, std::ostream& err, const std::vector<JobResult>& results, bool is_verbose);

/// Prints the errors of jobs without a result, as their commands reported them. With -q nothing else is printed.
void print_failures(std::ostream& err, const std::vector<JobResult>& results);

}  // namespace gouge
