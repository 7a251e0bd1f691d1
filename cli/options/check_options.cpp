#include "cli/options/check_options.h"

#include <CLI/CLI.hpp>

#include "cli/options/baseline.h"
#include "cli/options/job_options.h"
#include "cli/terminal/length_text.h"

namespace gouge {

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
                     "Write the proofs for 'gougecheck verify RESULT.json --certificate FILE' (- for standard output)")
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

void add_options_of_checks(CLI::App& command, CheckArguments& check) {
  static const OptionRows<JobArguments> stock = rows_of_projects(stock_options()),
                                        left_stock = rows_of_projects(left_stock_options());
  static const OptionRows<CheckArguments> searches = rows_of_projects(check_options());
  add_common_job_options(command, check.job, false);
  add_options(command, check.job, stock);
  add_options(command, check.job, left_stock);
  add_options(command, check, searches);
  add_baseline_option(command, check.job.baseline_file);
}

std::optional<Diagnostic> find_wrong_value(const CheckArguments& arguments) {
  if (const Result<JobOptions> options = understand(arguments.job); !options) return options.error();
  if (const Result<StickoutOptions> stickout = understand_stickout(arguments); !stickout) return stickout.error();
  return find_wrong_stock(arguments.job);
}

}  // namespace gouge
