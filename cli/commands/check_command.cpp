#include "cli/commands/check_command.h"

#include <CLI/CLI.hpp>
#include <ostream>
#include <utility>
#include <vector>

#include "cli/job/claimed_scene.h"
#include "cli/job/job.h"
#include "cli/job/setup_notes.h"
#include "cli/job/stickouts.h"
#include "cli/options/baseline.h"
#include "cli/output/outputs.h"
#include "cli/terminal/length_text.h"
#include "cli/terminal/print_diagnostics.h"
#include "lib/base/exit_code.h"
#include "lib/certify/check.h"
#include "lib/cure/find_cures.h"

namespace gouge {

namespace {

Result<StickoutOptions> understand_stickout(const CheckArguments& arguments) {
  const Result<double> step = understand_length("--stickout-step", arguments.stickout_step, Least::above_zero);
  if (!step) return step.error();
  const Result<double> most = understand_length("--stickout-limit", arguments.stickout_limit, Least::above_zero);
  if (!most) return most.error();
  constexpr double kMostSteps = 1e6;
  if (*step > *most || *most > kMostSteps * *step)
    return usage_error("--stickout-step", arguments.stickout_step,
                       "a length up to --stickout-limit, and no less than a millionth of it");
  return StickoutOptions{*step, *most};
}

}  // namespace

void add_check_options(CLI::App& command, CheckArguments& check) {
  JobArguments& arguments = check.job;
  add_job_options(command, arguments);
  add_baseline_option(command, arguments.baseline_file);
  command.option_defaults()->group("Check");
  command.add_flag("--find-cures", check.finds_cures,
                   "Find for every gouge of shank, holder or head the tilt and the least lift that free it");
  CLI::Option* const finds = command.add_flag(
      "--find-stickout", check.finds_stickout,
      "Find for every tool the least longer stick-out with which shank, holder and heads gouge no more");
  command.add_option("--stickout-step", check.stickout_step, "Stick-outs to try are multiples of this")
      ->type_name("LENGTH")
      ->capture_default_str()
      ->needs(finds);
  command.add_option("--stickout-limit", check.stickout_limit, "How much longer a stick-out may be at most")
      ->type_name("LENGTH")
      ->capture_default_str()
      ->needs(finds);
  command
      .add_option(
          "--certificate", arguments.certificate_file,
          "Write proofs that 'gougecheck verify RESULT.json --certificate FILE' verifies (- for standard output)")
      ->type_name("FILE")
      ->group(kOutputGroup);
  command
      .add_flag("--force", arguments.is_forced,
                "Let --report replace and remove files of a report's names that no report wrote, never an input")
      ->group(kOutputGroup);
  command.footer(
      "Example:\n"
      "  gougecheck check finish.apt --part part.stl --tools tools.json --report out\n\n"
      "Lengths are in mm, at most 100000; a unit may be given: 0.0005in. Exit status: 0 checked and clean, 1 gouges, 2 "
      "wrong command line, 3 input invalid, 4 not fully checked, 5 internal or resource failure.");
}

std::optional<Diagnostic> find_wrong_value(const CheckArguments& arguments) {
  if (const Result<JobOptions> options = understand(arguments.job); !options) return options.error();
  if (const Result<StickoutOptions> stickout = understand_stickout(arguments); !stickout) return stickout.error();
  return std::nullopt;
}

int run_check(const CheckArguments& check_arguments, const JobContext& context) {
  std::ostream& err = context.err;
  const JobArguments& arguments = check_arguments.job;
  const Result<JobOptions> options = understand(arguments);
  if (!options) return fail(err, {options.error()});
  const Result<StickoutOptions> stickout = understand_stickout(check_arguments);
  if (!stickout) return fail(err, {stickout.error()});
  JobOutputs outputs(arguments, {});
  if (const auto status = outputs.refuse(err)) return *status;
  const Result<LoadedBaseline> baseline = load_baseline(arguments.baseline_file, arguments.input);
  if (!baseline) return fail(err, {baseline.error()});
  Progress progress(err, options->progress);
  LoadedJob loaded = load_job(arguments, *options, progress, context.scenes);
  progress.end();
  if (!loaded.job) return fail(err, loaded.errors);
  Job& job = *loaded.job;
  const PreparedScene& scene = job.files->prepared(options->check.threads, progress.call());
  progress.begin("checking the set-up");
  note_setup(job, arguments, scene);
  CheckSetup setup = job.setup(scene);
  if (context.keep_work) setup.kept = context.keep_work(job.inputs);
  const CheckResult result = check(job.toolpath, setup, progress.call());
  std::vector<StickoutFacts> stickouts;
  if (check_arguments.finds_stickout) {
    Result<std::vector<StickoutFacts>> found =
        find_stickouts_of(job, scene, result, arguments.is_extended_up, *stickout, progress.call());
    if (!found) {
      progress.end();
      return fail(err, {found.error()});
    }
    stickouts = std::move(*found);
  }
  const CureOptions cure_options;
  std::vector<FindingCures> cures;
  if (check_arguments.finds_cures)
    cures = find_cures(job.toolpath, result, job.setup(scene), cure_options, progress.call());
  progress.begin("summing up the result");
  ReportModel model = job.report(arguments, job.toolpath, result);
  if (check_arguments.finds_stickout) model.stickout_options = *stickout;
  model.stickouts = std::move(stickouts);
  if (check_arguments.finds_cures) model.cure_options = cure_options;
  model.cures = std::move(cures);
  baseline->apply(model);
  MadeCertificate certificate;
  if (!arguments.certificate_file.empty()) {
    certificate = make_certificate(claimed_scene(job), claims_of(result), inputs_digest(job.inputs), progress.call());
    model.certificate_bytes = certificate.bytes;
  }
  progress.end();
  print_notes(err, model.notes, arguments);
  if (arguments.is_quiet) print(err, open_warnings(result.assumptions));
  if (!certificate.not_proved.empty() && !arguments.is_quiet) print(err, {describe_unproved(job, certificate)});
  if (arguments.is_verbose) {
    err << "spent: " << result.evaluations << " bounds in " << result.verdicts.size() << " moves\n";
  }
  const bool is_written = outputs.write(job, scene, model, progress, context.out, err);
  if (arguments.is_verbose) print_peak_memory(err);
  if (!is_written) return kExitInternal;
  if (context.on_result) context.on_result(model);
  return exit_status(overall_verdict(model));
}

}  // namespace gouge
