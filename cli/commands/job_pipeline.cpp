#include "cli/commands/job_pipeline.h"

#include <ostream>
#include <utility>

#include "cli/job/load_excess.h"
#include "cli/job/setup_notes.h"
#include "cli/terminal/length_text.h"
#include "cli/terminal/print_diagnostics.h"
#include "lib/base/exit_code.h"
#include "postproc/report/report_text.h"

namespace gouge {

JobPipeline::JobPipeline(const JobArguments& arguments, const JobOptions& options, const std::string& corrected,
                         const JobContext& context)
    : arguments_(arguments),
      options_(options),
      context_(context),
      outputs_(arguments, corrected),
      progress_(context.err, options.progress),
      printer_(context.err, arguments) {}

std::optional<int> JobPipeline::load() {
  if (const auto status = outputs_.refuse(context_.out, context_.err)) return status;
  Result<LoadedBaseline> accepted = load_baseline(arguments_.baseline_file, arguments_.input);
  if (!accepted) return fail_with({accepted.error()});
  baseline_ = std::move(*accepted);
  LoadedJob loaded = load_job(arguments_, options_, progress_, context_.scenes);
  progress_.end();
  if (context_.on_searches) context_.on_searches(loaded.searches);
  if (!loaded.job) {
    if (arguments_.project_file)
      loaded.errors.push_back(
          make_note(kProjectFile, arguments_.project_file->summary, arguments_.project_file->input.name));
    return fail_with(loaded.errors);
  }
  job_ = std::move(*loaded.job);
  scene_ = &job_->files->prepared(options_.check.threads, progress_.call());
  progress_.begin("checking the set-up");
  const Diagnostics notes = setup_notes(*job_, arguments_, *scene_);
  job_->notes.insert(job_->notes.end(), notes.begin(), notes.end());
  return std::nullopt;
}

std::optional<int> JobPipeline::load_stock(double clearance_mm) {
  progress_.begin("preparing the stock");
  Diagnostics errors;
  stock_ = gouge::load_stock(arguments_, *job_, progress_, errors);
  if (context_.on_searches) context_.on_searches(job_->searches);
  if (!stock_) return fail_with(errors);
  progress_.end();
  if (const auto error = add_roomy_tools(clearance_mm, arguments_, *job_, *stock_)) return fail_with({*error});
  if (const Outcome excess = load_excess(arguments_, *scene_, *stock_->setup); !excess)
    return fail_with({excess.error()});
  return std::nullopt;
}

std::optional<int> JobPipeline::make_stock_meshes(ReportParts& parts) {
  if (arguments_.write_stock.empty() && arguments_.report_folder.empty()) return std::nullopt;
  Result<StockMeshes> meshes = gouge::make_stock_meshes(arguments_, *job_, *stock_->setup, progress_.call());
  if (!meshes) return fail_with({meshes.error()});
  meshes_ = std::move(*meshes);
  if (!meshes_->remaining.perhaps.triangles.empty()) parts.shown_stock = &meshes_->remaining.perhaps;
  if (arguments_.write_stock.empty()) return std::nullopt;
  parts.stock_left = meshes_->facts(arguments_);
  const Diagnostics notes = meshes_->notes(arguments_);
  parts.notes.insert(parts.notes.end(), notes.begin(), notes.end());
  return std::nullopt;
}

CheckResult JobPipeline::check() {
  CheckSetup checked = setup();
  checked.stock = stock();
  return check_with(std::move(checked));
}

CheckResult JobPipeline::check_without_stock() { return check_with(setup()); }

CheckResult JobPipeline::check_with(CheckSetup checked) {
  progress_.end();
  printer_.print_new(job_->notes);
  if (context_.checkpoints_of) checked.kept = context_.checkpoints_of(job_->inputs);
  return gouge::check(job_->toolpath, checked, progress_.call());
}

ReportModel JobPipeline::report(const Toolpath& path, const CheckResult& result, ReportParts parts) const {
  ReportModel model = job_->report(arguments_, path, result, std::move(parts));
  baseline_.apply(model);
  return model;
}

int JobPipeline::write(const ReportModel& model, const Diagnostics& last_notes, const std::string& spent) {
  std::ostream& err = context_.err;
  progress_.end();
  printer_.print_new(model.notes);
  printer_.print_rest();
  if (arguments_.is_quiet) print(err, open_warnings(model.result->assumptions));
  if (!arguments_.is_quiet) print(err, last_notes);
  if (arguments_.is_verbose) err << spent;
  const bool is_written = outputs_.write(*job_, *scene_, model, progress_, context_.out, err);
  if (arguments_.is_verbose) print_peak_memory(err);
  if (!is_written) return kExitInternal;
  if (context_.on_searches) context_.on_searches(job_->searches);
  if (context_.on_result) context_.on_result(model);
  return exit_status(overall_verdict(model));
}

int JobPipeline::fail_with(const Diagnostics& errors) { return fail_with(errors, status_of(errors)); }

int JobPipeline::fail_with(const Diagnostics& errors, int status) {
  progress_.end();
  print(context_.err, errors);
  if (status == kExitUsage) return status;
  const Outcome written = outputs_.write_failure({arguments_.path, status, errors}, context_.out);
  if (!written) print(context_.err, {written.error()});
  return status;
}

}  // namespace gouge
