#include "cli/commands/check_command.h"

#include <string>
#include <utility>
#include <vector>

#include "cli/commands/job_pipeline.h"
#include "cli/job/claimed_scene.h"
#include "cli/job/compare_laws.h"
#include "cli/job/setup_notes.h"
#include "cli/terminal/print_diagnostics.h"
#include "lib/cure/find_cures.h"
#include "postproc/formats/write_corrected.h"

namespace gouge {
namespace {

/// Runs the searches by which the options of `check` extend its report.
Result<ReportParts> find_parts(const CheckArguments& arguments, const StickoutOptions& stickout,
                               const CheckResult& result, JobPipeline& run) {
  ReportParts parts;
  const Job& job = run.job();
  if (arguments.compares_laws) parts.laws = compare_laws(job, run.scene(), run.progress().call());
  if (arguments.finds_stickout) {
    Result<std::vector<StickoutFacts>> found =
        find_stickouts_of(job, run.scene(), result, arguments.job.is_extended_up, stickout, run.progress().call());
    if (!found) return found.error();
    parts.stickout_options = stickout;
    parts.stickouts = std::move(*found);
  }
  if (arguments.finds_cures) {
    parts.cure_options = CureOptions();
    parts.cure_options->tilt.reach = job.reach();
    parts.cures = find_cures(job.toolpath, result, run.setup(), *parts.cure_options, run.progress().call());
    const bool is_corrected = !parts.cures.empty() && job.toolpath.dialect != gcode_dialect().id;
    parts.cure_options->has_axes = !is_corrected || rewritable_moves(job.toolpath).has_axes;
  }
  return parts;
}

/// Makes the certificate of a result, with proofs about stock if the check has one.
MadeCertificate prove(const JobArguments& arguments, const CheckResult& result, JobPipeline& run) {
  const Job& job = run.job();
  const std::string digest = inputs_digest(job.inputs, job, arguments);
  const ProgressCall progress = run.progress().call();
  if (run.loaded_stock() == nullptr) return make_certificate(claimed_scene(job), claims_of(result), digest, progress);
  const ClaimedStock stock = claimed_stock(job, arguments, *run.loaded_stock());
  const StockDepths depths = stock_depths_of(result, stock);
  const StockClaims claims(stock, depths);
  return make_certificate(claimed_scene(job), claims_of(result), digest, progress, &claims);
}

}  // namespace

int run_check(const CheckArguments& arguments, const JobContext& context) {
  const Result<JobOptions> options = understand(arguments.job);
  if (!options) return fail(context.err, {options.error()});
  const Result<StickoutOptions> stickout = understand_stickout(arguments);
  if (!stickout) return fail(context.err, {stickout.error()});
  if (arguments.compares_laws && arguments.job.machine.empty())
    return fail(context.err, {make_error("usage", "--laws: expected --machine beside it, whose laws are compared")});
  if (const auto wrong = find_wrong_stock(arguments.job)) return fail(context.err, {*wrong});
  JobPipeline run(arguments.job, *options, {}, context);
  if (const auto status = run.load()) return *status;
  if (!arguments.job.stock.empty()) {
    if (const auto status = run.load_stock()) return *status;
  }
  const Job& job = run.job();
  const CheckResult result = run.check();
  Result<ReportParts> parts = find_parts(arguments, *stickout, result, run);
  if (!parts) return run.fail_with({parts.error()});
  if (!arguments.job.stock.empty()) {
    if (const auto status = run.make_stock_meshes(*parts)) return *status;
  }
  run.progress().begin("summing up the result");
  MadeCertificate certificate;
  if (!arguments.job.certificate_file.empty()) {
    certificate = prove(arguments.job, result, run);
    parts->certificate_bytes = certificate.bytes;
  }
  const Diagnostics unproved = describe_unproved(job, certificate);
  const std::string spent = "spent: " + std::to_string(result.evaluations) + " bounds in " +
                            std::to_string(result.verdicts.size()) + " moves\n";
  return run.write(run.report(job.toolpath, result, std::move(*parts)), unproved, spent);
}

}  // namespace gouge
