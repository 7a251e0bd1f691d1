#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "cli/job/job.h"
#include "cli/options/job_options.h"
#include "cli/output/report_folder.h"
#include "lib/base/result.h"
#include "lib/base/text_writer.h"
#include "postproc/export/write_scene.h"

namespace gouge {

struct FailedRun;
struct ReportModel;

/// One output of a command line. All code that protects files, keeps standard output separate or writes uses these
/// tables. So an output that is in no table cannot be requested.
struct Output {
  enum class Kind { file, report_folder };

  std::string option;  ///< "--csv"
  std::string file;    ///< as the user named it; "-" for a file: standard output
  Kind kind = Kind::file;
  void (*write)(const ReportModel&, const PutText&) = nullptr;  ///< for a file of `check` and `correct`
  WriteScene write_scene = nullptr;                             ///< in place of `write`, for an exported scene
  bool (*has_content)(const ReportModel&) = nullptr;         ///< the file is written only if it is true; null: always
  std::string (*write_failure)(const FailedRun&) = nullptr;  ///< for a run without a result; null: nothing is written
};

using OutputTable = std::vector<Output>;

/// Returns the outputs requested of `check` and `correct`; `corrected` is the file of -o, or empty.
[[nodiscard]] OutputTable outputs_of(const JobArguments& arguments, const std::string& corrected);

/// Returns the outputs that are requested: those with a name that is not empty.
[[nodiscard]] OutputTable asked_for(const OutputTable& outputs);

/// Returns whether one of them is "-": standard output then has nothing else. Errors: usage, if more than one is.
[[nodiscard]] Result<bool> is_stdout_taken(const OutputTable& outputs);

/// Returns the folder of --report, or empty.
[[nodiscard]] std::string report_folder_of(const OutputTable& outputs);

/// The outputs of one run of `check` or `correct`. All are complete before any is put in its place; the terminal is
/// last.
class JobOutputs {
 public:
  /// `corrected` is the file for the corrected toolpath, or empty.
  JobOutputs(const JobArguments& arguments, const std::string& corrected);

  /// Prints errors of the outputs before the work, and returns the exit status; returns none if there is no error. The
  /// folder of the report, if it exists, is then locked. Outputs that can state the error are written.
  [[nodiscard]] std::optional<int> refuse(std::ostream& out, std::ostream& err);

  /// Writes every file requested, then prints the findings. The `scene` is that of the job. A file that cannot be
  /// written is reported on `err`, last. Returns whether all was written, and delivered in the case of standard output.
  [[nodiscard]] bool write(const Job& job, const PreparedScene& scene, const ReportModel& model, Progress& progress,
                           std::ostream& out, std::ostream& err);

  /// Writes the files whose formats can state that a run ended without a result, each for itself. Writes nothing if an
  /// output would replace an input or another output. Returns the first error.
  [[nodiscard]] Outcome write_failure(const FailedRun& run, std::ostream& out) const;

 private:
  [[nodiscard]] Outcome write_files(const Job& job, const PreparedScene& scene, const ReportModel& model,
                                    Progress& progress, std::ostream& out);
  [[nodiscard]] Outcome stage_report(const Job& job, const PreparedScene& scene, const ReportModel& model,
                                     Progress& progress);
  void print_findings(const ReportModel& model, bool is_written, std::ostream& out) const;

  const JobArguments& arguments_;
  OutputTable outputs_;
  std::optional<ReportFolder> report_;
};

}  // namespace gouge
