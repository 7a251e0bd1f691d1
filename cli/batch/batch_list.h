#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "cli/commands/check_command.h"
#include "cli/options/correct_options.h"
#include "cli/output/report_folder.h"
#include "lib/base/result.h"

namespace gouge {

/// One job of a batch. Its words are understood, but its files may be missing.
struct BatchJob {
  std::string name;
  std::size_t line = 0;            ///< line in the job list; 0: the job is on the command line
  std::vector<std::string> words;  ///< its options as a command line, without outputs below the folder of the batch
  bool has_report = true;
  bool has_own_certificate = false;  ///< it writes its certificate into the folder of the batch
  bool leaves_baseline = false;      ///< it corrects, so the baseline in the defaults of its list does not hold for it
  std::variant<CheckArguments, CorrectArguments> arguments;
  std::optional<Diagnostic> refusal;  ///< error with which it fails, as its file has a name that no job can have

  [[nodiscard]] const char* command() const { return arguments.index() == 0 ? "check" : "correct"; }
  [[nodiscard]] JobArguments& job();
  [[nodiscard]] const JobArguments& job() const;
  /// Returns the file for a corrected toolpath; empty for `check`.
  [[nodiscard]] std::string output() const;
};

/// Folder for the output of a batch's jobs.
struct BatchFolder {
  std::string path;
  bool has_reports = true;        ///< false: no job has a report, even if it requests one
  bool has_certificates = false;  ///< true: every check without a certificate of its own writes one into the folder

  [[nodiscard]] std::string report_of(const std::string& job) const { return path + "/" + kReportsFolder + "/" + job; }
  /// Returns the name of a job's corrected toolpath, relative to `path`.
  [[nodiscard]] static std::string corrected_name(const BatchJob& job);
  /// Returns the name of a job's certificate, relative to `path`.
  [[nodiscard]] static std::string certificate_name(const BatchJob& job);
  /// Returns the names, relative to `path`, of the files other than its report that a job writes into the folder.
  [[nodiscard]] std::vector<std::string> own_outputs(const BatchJob& job) const;
};

/// Reads a job list (docs/formats/batch.md). Relative files in it are below its folder. Errors: the first error in it,
/// with its line: jobs-syntax, jobs-duplicate-key, jobs-field, jobs-option, and those of reading a file.
[[nodiscard]] Result<std::vector<BatchJob>> read_job_list(const std::string& file, const BatchFolder& folder);

/// Returns jobs that check toolpaths with the same options, named after their files (names_of_toolpaths). `places` are
/// toolpaths, and folders of toolpaths. A file name that can name no job gives a job that fails. Errors: usage.
[[nodiscard]] Result<std::vector<BatchJob>> list_jobs(const std::vector<std::string>& places,
                                                      const std::vector<std::string>& words, const BatchFolder& folder);

}  // namespace gouge
