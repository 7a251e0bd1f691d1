#include "cli/commands/check_command.h"

#include <CLI/CLI.hpp>
#include <string>
#include <utility>
#include <vector>

#include "cli/commands/job_pipeline.h"
#include "cli/job/claimed_scene.h"
#include "cli/job/compare_laws.h"
#include "cli/job/setup_notes.h"
#include "cli/options/baseline.h"
#include "cli/terminal/length_text.h"
#include "cli/terminal/print_diagnostics.h"
#include "lib/cure/find_cures.h"
#include "postproc/formats/write_corrected.h"

namespace gouge {

namespace {

Result<StickoutOptions> understand_stickout(const CheckArguments& arguments) {
  const Result<double> step = understand_length("--stickout-step", arguments.stickout_step, Minimum::above_zero);
  if (!step) return step.error();
  const Result<double> most = understand_length("--stickout-limit", arguments.stickout_limit, Minimum::above_zero);
  if (!most) return most.error();
  constexpr double kMaxSteps = 1e6;
  if (*step > *most || *most > kMaxSteps * *step)
    return usage_error("--stickout-step", arguments.stickout_step,
                       "a length up to --stickout-limit, and no less than a millionth of it");
  return StickoutOptions{*step, *most};
}

}  // namespace

const OptionRows<CheckArguments>& check_options() {
  using A = CheckArguments;
  static const OptionRows<A> rows = {
      {.name = "--find-cures",
       .field = &A::finds_cures,
       .group = "Check",
       .help = "For every gouge of shank, holder or head, find the tilt and the minimum lift that free it",
       .scope = Scope::project},
      {.name = "--laws",
       .field = &A::compares_laws,
       .help = "Check the path by every law of motion that --machine can run, and report what each would cut",
       .scope = Scope::project},
      {.name = "--find-stickout",
       .field = &A::finds_stickout,
       .help = "For every tool, find the minimum stick-out at which shank, holder and heads do not gouge",
       .scope = Scope::project},
      {.name = "--stickout-step",
       .field = &A::stickout_step,
       .type = "LENGTH",
       .help = "Step of the search: the stick-outs that are tried are multiples of this length",
       .scope = Scope::project,
       .needs = "--find-stickout"},
      {.name = "--stickout-limit",
       .field = &A::stickout_limit,
       .type = "LENGTH",
       .help = "Maximum length that the search may add to a stick-out",
       .scope = Scope::project,
       .needs = "--find-stickout"},
      {.name = "--certificate",
       .field =
           +[](CLI::App& command, A& a) {
             command
                 .add_option(
                     "--certificate", a.job.certificate_file,
                     "Write the proofs for 'gougecheck verify RESULT.json --certificate FILE' (- for standard output). They are "
                     "about parts and fixtures, not about remaining stock")
                 ->type_name("FILE");
           },
       .group = kOutputGroup},
      {.name = "--force", .field = +[](CLI::App& command, A& a) {
         command.add_flag(
             "--force", a.job.is_forced,
             "Let --report replace and remove files that have names of a report but were not written by one, "
             "except inputs");
       }}};
  return rows;
}

void add_check_options(CLI::App& command, CheckArguments& check) {
  add_job_options(command, check.job);
  add_baseline_option(command, check.job.baseline_file);
  add_options(command, check.job, stock_options());
  add_options(command, check.job, left_stock_options());
  add_options(command, check, check_options());
  command.footer(
      "Example:\n"
      "  gougecheck check finish.apt --part part.stl --tools tools.json --report out\n\n"
      "Lengths in options are at most 100000 mm.\n\n"
      "Exit status: 0 checked and clean, 1 gouges or material left (--excess), 2 wrong command line, 3 input unreadable or invalid, 4 not "
      "fully checked, 5 internal or resource failure.");
}

std::optional<Diagnostic> find_wrong_value(const CheckArguments& arguments) {
  if (const Result<JobOptions> options = understand(arguments.job); !options) return options.error();
  if (const Result<StickoutOptions> stickout = understand_stickout(arguments); !stickout) return stickout.error();
  return find_wrong_stock(arguments.job);
}

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
  if (!parts) return run.fail_with(parts.error());
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
