#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/job/job.h"
#include "cli/job/job_context.h"
#include "cli/job/load_stock.h"
#include "cli/job/stock_meshes.h"
#include "cli/options/baseline.h"
#include "cli/output/outputs.h"
#include "cli/terminal/print_diagnostics.h"
#include "cli/terminal/progress.h"

namespace gouge {

/// The steps that `check` and `correct` share: load, check, report, write. Each returns a value, and no later step
/// changes it.
class JobPipeline {
 public:
  /// All arguments must outlive the run. `corrected` is the file for the corrected toolpath, or empty.
  JobPipeline(const JobArguments& arguments, const JobOptions& options, const std::string& corrected,
              const JobContext& context);

  /// Opens the outputs, reads all inputs and compares the fixtures with the parts. If the run must end here, prints the
  /// errors and returns the exit status; otherwise returns none.
  [[nodiscard]] std::optional<int> load();

  /// Makes the stock, which `check` then examines. Returns the exit status if there is an error. Corrected rapids shall
  /// keep `clearance_mm` from it.
  [[nodiscard]] std::optional<int> load_stock(double clearance_mm = 0);

  /// Makes the meshes of the remaining stock that the outputs need. Returns the exit status if there is an error.
  /// Requires load_stock.
  [[nodiscard]] std::optional<int> make_stock_meshes(ReportParts& parts);

  /// Prints the warnings about the inputs, so that a user sees them before a long check. Then checks the path as it was
  /// read. This and all functions below require that `load` returned none.
  [[nodiscard]] CheckResult check();
  /// Does the same without the stock.
  [[nodiscard]] CheckResult check_without_stock();

  /// Builds the report of `result` for `path`, with the accepted findings. Both must outlive the report.
  [[nodiscard]] ReportModel report(const Toolpath& path, const CheckResult& result, ReportParts parts) const;

  /// Prints the warnings that are not printed yet, writes every output and prints the findings. Returns the exit status.
  /// `last_notes` are printed after those of the report, but not with -q; `spent` is printed with -v.
  [[nodiscard]] int write(const ReportModel& model, const Diagnostics& last_notes = {}, const std::string& spent = {});

  /// Ends the progress line, prints the errors and writes the outputs that can state them. Returns the exit status.
  [[nodiscard]] int fail_with(const Diagnostics& errors);
  [[nodiscard]] int fail_with(const Diagnostics& errors, int status);

  [[nodiscard]] const Job& job() const { return *job_; }
  [[nodiscard]] const PreparedScene& scene() const { return *scene_; }
  [[nodiscard]] CheckSetup setup() const { return job_->setup(*scene_); }
  /// Returns the stock; null: none was loaded.
  [[nodiscard]] const StockSetup* stock() const { return stock_ ? &*stock_->setup : nullptr; }
  /// Returns the same with its meshes and tools.
  [[nodiscard]] const LoadedStock* loaded_stock() const { return stock_ ? &*stock_ : nullptr; }
  [[nodiscard]] Progress& progress() { return progress_; }

 private:
  [[nodiscard]] CheckResult check_with(CheckSetup checked);

  const JobArguments& arguments_;
  const JobOptions& options_;
  const JobContext& context_;
  JobOutputs outputs_;
  Progress progress_;
  NotePrinter printer_;
  LoadedBaseline baseline_;
  std::optional<Job> job_;
  const PreparedScene* scene_ = nullptr;
  std::optional<LoadedStock> stock_;
  std::optional<StockMeshes> meshes_;
};

}  // namespace gouge
