#include "cli/check_command.h"

#include <CLI/CLI.hpp>
#include <ostream>

#include "cli/job.h"
#include "cli/outputs.h"
#include "cli/path_misfit.h"
#include "cli/print_diagnostics.h"
#include "cli/setup_notes.h"
#include "lib/base/exit_code.h"
#include "lib/certify/check.h"

namespace gouge {

void add_check_options(CLI::App& command, JobArguments& arguments) {
  add_job_options(command, arguments);
  command.add_flag("--force", arguments.is_forced,
                   "Let --report replace and remove files of a report's names that no report wrote, never an input");
  command.footer(
      "Example:\n"
      "  gougecheck check finish.apt --part part.stl --tools tools.json --report out\n\n"
      "Lengths are in mm, at most 100000; a unit may be given: 0.0005in. Exit status: 0 checked and clean, 1 gouges, 2 "
      "wrong command line, 3 input invalid, 4 not fully checked, 5 internal or resource failure.");
}

int run_check(const JobArguments& arguments, std::ostream& out, std::ostream& err) {
  const Result<JobOptions> options = understand(arguments);
  if (!options) return fail(err, {options.error()});
  JobOutputs outputs(arguments, {});
  if (const auto status = outputs.refuse(err)) return *status;
  Progress progress(err, options->progress);
  LoadedJob loaded = load_job(arguments, *options, progress);
  progress.end();
  if (!loaded.job) return fail(err, loaded.errors);
  Job& job = *loaded.job;
  progress.begin("indexing the meshes");
  const PreparedScene scene = prepare_scene(job.scene, options->check.threads);
  progress.begin("checking the set-up");
  note_setup(job, arguments, scene);
  const CheckResult result = check(job.toolpath, job.setup(scene), progress.call());
  progress.end();
  ReportModel model = job.report(arguments, job.toolpath, result, scene);
  const PathFit fit = find_path_fit(job.toolpath, result.verdicts, job.tools(), scene, options->check.threads);
  if (const auto misfit = describe_misfit(job.toolpath, fit)) model.notes.push_back(*misfit);
  print_notes(err, model.notes, arguments);
  if (arguments.is_verbose) {
    err << "spent: " << result.evaluations << " bounds in " << result.verdicts.size() << " moves\n";
  }
  const bool is_written = outputs.write(job, scene, model, progress, out, err);
  if (arguments.is_verbose) print_peak_memory(err);
  if (!is_written) return kExitInternal;
  return exit_status(overall_verdict(result));
}

}  // namespace gouge
