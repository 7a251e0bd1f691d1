#pragma once

#include <iosfwd>
#include <optional>
#include <string>

#include "cli/job/job.h"
#include "cli/output/output_table.h"
#include "cli/output/report_folder.h"

namespace gouge {

/// What one run of `check` or `correct` writes. All of it stands before anything of it is put in its place;
/// the terminal comes last.
class JobOutputs {
 public:
  /// `corrected` is where the corrected toolpath goes, or empty.
  JobOutputs(const JobArguments& arguments, const std::string& corrected);

  /// Before the work: what is wrong with the outputs is printed, and the result is the exit status. None
  /// where all is well; the report's folder, if it exists, is then locked.
  [[nodiscard]] std::optional<int> refuse(std::ostream& err);

  /// `scene` is that of the job. Writes every file asked for, then prints the findings. What cannot be written is
  /// reported on `err`. Returns whether all was written, and delivered where it is standard output's.
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
