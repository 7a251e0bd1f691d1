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

struct ReportModel;

/// One output of a command line. Whatever protects files, keeps standard output apart or writes follows these
/// tables alone, so an output that is in none cannot be requested.
struct Output {
  enum class Kind { file, report_folder };

  std::string option;  ///< "--csv"
  std::string file;    ///< as the user named it; "-": standard output, for a file
  Kind kind = Kind::file;
  void (*write)(const ReportModel&, const PutText&) = nullptr;  ///< of `check` and `correct`, for a file
  WriteScene write_scene = nullptr;                             ///< in place of it, for an exported scene
};

using OutputTable = std::vector<Output>;

/// Returns the outputs requested of `check` and `correct`, where `corrected` is what -o names, or empty.
[[nodiscard]] OutputTable outputs_of(const JobArguments& arguments, const std::string& corrected);

/// Returns those of `outputs` that are requested: without empty names.
[[nodiscard]] OutputTable asked_for(const OutputTable& outputs);

/// Returns whether one of them is "-", so that standard output belongs to it alone. Errors: usage, for more than one.
[[nodiscard]] Result<bool> is_stdout_taken(const OutputTable& outputs);

/// Returns the folder of --report, or empty.
[[nodiscard]] std::string report_folder_of(const OutputTable& outputs);

/// The outputs of one run of `check` or `correct`. All are complete before any is put in its place;
/// the terminal comes last.
class JobOutputs {
 public:
  /// `corrected` is where the corrected toolpath goes, or empty.
  JobOutputs(const JobArguments& arguments, const std::string& corrected);

  /// Prints errors of the outputs before the work, and returns the exit status. None where all is well; the report's
  /// folder, if it exists, is then locked.
  [[nodiscard]] std::optional<int> refuse(std::ostream& err);

  /// Writes every file requested, then prints the findings. The `scene` is that of the job. A file that cannot be
  /// written is reported on `err`. Returns whether all was written, and delivered where it is standard output's.
  [[nodiscard]] bool write(const Job& job, const PreparedScene& scene, const ReportModel& model, Progress& progress,
                           std::ostream& out, std::ostream& err);

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
