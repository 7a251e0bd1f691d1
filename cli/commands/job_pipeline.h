#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/job/job.h"
#include "cli/job/job_context.h"
#include "cli/options/baseline.h"
#include "cli/output/outputs.h"
#include "cli/terminal/progress.h"

namespace gouge {

/// The steps that `check` and `correct` share: load, check, report, write. Each returns a value; nothing that a step
/// returned is changed by a later one.
class JobPipeline {
 public:
  /// All must outlive the run. `corrected` is where the corrected toolpath goes, or empty.
  JobPipeline(const JobArguments& arguments, const JobOptions& options, const std::string& corrected,
              const JobContext& context);

  /// Opens the outputs, reads all inputs and compares the fixtures with the parts. Returns the exit status where the
  /// run ends here, with the errors printed; otherwise none.
  [[nodiscard]] std::optional<int> load();

  /// Checks the path as it was read. Requires that `load` returned none, as do all that follow.
  [[nodiscard]] CheckResult check();

  /// Builds the report of `result` for `path`, with what is accepted of it. Both must outlive it.
  [[nodiscard]] ReportModel report(const Toolpath& path, const CheckResult& result, ReportParts parts) const;

  /// Prints the warnings, writes every output and prints the findings. Returns the exit status. `last_notes`: printed
  /// after those of the report, not with -q; `spent`: printed with -v.
  [[nodiscard]] int write(const ReportModel& model, const Diagnostics& last_notes = {}, const std::string& spent = {});

  /// Ends the progress line and prints `error`. Returns the exit status.
  [[nodiscard]] int fail_with(const Diagnostic& error);
  [[nodiscard]] int fail_with(const Diagnostic& error, int status);

  [[nodiscard]] const Job& job() const { return *job_; }
  [[nodiscard]] const PreparedScene& scene() const { return *scene_; }
  [[nodiscard]] CheckSetup setup() const { return job_->setup(*scene_); }
  [[nodiscard]] Progress& progress() { return progress_; }

 private:
  const JobArguments& arguments_;
  const JobOptions& options_;
  const JobContext& context_;
  JobOutputs outputs_;
  Progress progress_;
  LoadedBaseline baseline_;
  std::optional<Job> job_;
  const PreparedScene* scene_ = nullptr;
};

}  // namespace gouge
