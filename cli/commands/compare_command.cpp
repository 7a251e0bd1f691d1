#include "cli/commands/compare_command.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <ostream>
#include <utility>

#include "cli/commands/batch_results.h"
#include "cli/commands/compare_batches.h"
#include "cli/commands/compare_paths.h"
#include "cli/commands/load_result.h"
#include "cli/commands/reading_of_new.h"
#include "cli/output/output_file.h"
#include "cli/output/report_folder.h"
#include "cli/terminal/length_text.h"
#include "lib/base/exit_code.h"
#include "lib/base/file_kind.h"
#include "lib/base/files.h"
#include "postproc/compare/write_comparison.h"

namespace gouge {
namespace {

/// Lets the options from number `first` on hold with --paths alone, except for the limit of input files.
void bind_to_paths(CLI::App& command, std::size_t first) {
  CLI::Option* const paths = command.get_option("--paths");
  const std::vector<CLI::Option*> options = command.get_options([](const CLI::Option*) { return true; });
  for (std::size_t k = first; k < options.size(); ++k)
    if (!options[k]->check_lname("max-input")) options[k]->needs(paths);
}

}  // namespace

void add_compare_options(CLI::App& command, CompareArguments& arguments) {
  command
      .add_option("OLD", arguments.before,
                  "Result of the old run: the output of --json, the folder of a report, or the folder of a batch")
      ->type_name("FILE")
      ->required();
  command.add_option("NEW", arguments.after, "Result of the new run")->type_name("FILE")->required();
  command
      .add_option("--same-within", arguments.same_within,
                  "Maximum difference of depths that count as equal. For a part that was tessellated again, give "
                  "its chord error")
      ->type_name("LENGTH")
      ->capture_default_str();
  command
      .add_option("--html", arguments.html_file,
                  "Write the comparison as HTML (- for standard output, without other text)")
      ->type_name("FILE");
  command
      .add_option("--json", arguments.json_file,
                  "Write the comparison as JSON (- for standard output, without other text)")
      ->type_name("FILE");
  command.add_flag(
      "--paths", arguments.are_paths,
      "OLD and NEW are two readings of a toolpath, such as CL data and the program made of it: show the "
      "largest distance of their tips and axes, feeds that became rapids, another order, and the first feed "
      "rate that differs");
  const std::size_t first = command.get_options().size();
  add_program_reading(command, arguments, MachineOption::possible);
  add_reading_of_new(command, arguments.of_new);
  bind_to_paths(command, first);
  add_verbosity(command, arguments, "List the unchanged findings too (not with -q)");
  command.footer(
      "Examples:\n"
      "  gougecheck compare monday/result.json today/result.json --html changes.html\n"
      "  gougecheck compare night1 night2 --html changes.html    # two batches\n"
      "  gougecheck compare --paths part.cls part.nc --machine umc.json\n\n"
      "Two findings are the same if the same motions gouge, with the same tool and body. If the other path does "
      "not have these motions, the statement and the place on the part are compared, or the place alone. A "
      "finding is gone only if the new run checked the motions of this finding, or the moves that replace "
      "them.\n\n"
      "Exit status: 0 no finding is new or deeper; 1 a finding is new or deeper; 2 wrong command line; 3 input "
      "unreadable; 4 a finding is not checked any more, or the new run has moves that are not checked or not "
      "certified; 5 internal failure or output unwritable.");
}

namespace {

/// Returns the error about a file that is no result, with the option that compares toolpaths if it is one.
Diagnostic with_hint_at_paths(Diagnostic error, const InputLimit& limit) {
  const Result<std::string> bytes =
      error.code == "result-syntax" ? read_file(error.file, limit.max_bytes) : std::string();
  if (bytes && looks_like_cl_data(*bytes))
    error.message = "is a toolpath, not a result; two toolpaths are compared with --paths";
  return error;
}

}  // namespace

Outcome write_comparison(const CompareArguments& arguments, const std::function<std::string()>& html,
                         const std::function<std::string()>& json, std::ostream& out) {
  PendingOutputs pending;
  for (const auto& [file, make] : {std::pair(arguments.html_file, html), std::pair(arguments.json_file, json)}) {
    if (file.empty()) continue;
    if (const Outcome added = pending.add(file, make()); !added) return added;
  }
  return pending.commit(out);
}

int run_compare(const CompareArguments& arguments, std::ostream& out, std::ostream& err) {
  if (const auto error = find_contradiction(arguments)) return fail(err, {*error});
  const Result<double> same_within = understand_length("--same-within", arguments.same_within, Minimum::zero);
  if (!same_within) return fail(err, {same_within.error()});
  if (arguments.are_paths && !arguments.html_file.empty())
    return fail(err, {make_error("usage", "--html writes a comparison of results; --paths takes --json FILE")});
  if (arguments.are_paths) return run_compare_paths(arguments, *same_within, out, err);
  const bool is_old_batch = is_batch_folder(arguments.before), is_new_batch = is_batch_folder(arguments.after);
  if (is_old_batch && is_new_batch) return run_compare_batches(arguments, *same_within, out, err);
  if (is_old_batch || is_new_batch) {
    const std::string &batch = is_old_batch ? arguments.before : arguments.after,
                      &other = is_old_batch ? arguments.after : arguments.before;
    std::error_code ignored;
    if (!std::filesystem::exists(other, ignored))
      return fail(err, {make_error("file-not-found", "no such folder; expected that of another batch", other)});
    return fail(
        err, {make_error("usage", batch + " is the folder of a batch, but " + other + " " + describe_no_batch(other))});
  }
  const OutputTable outputs = asked_for({{"--html", arguments.html_file}, {"--json", arguments.json_file}});
  const Result<bool> taken = is_stdout_taken(outputs);
  if (const auto status = refuse_outputs(
          {{"the old result", result_in(arguments.before)}, {"the new result", result_in(arguments.after)}}, outputs,
          err))
    return *status;
  const Result<StoredResult> before = load_result(arguments.before, arguments.input);
  if (!before) return fail(err, {with_hint_at_paths(before.error(), arguments.input)});
  const Result<StoredResult> after = load_result(arguments.after, arguments.input);
  if (!after) return fail(err, {with_hint_at_paths(after.error(), arguments.input)});
  const Comparison comparison = compare_results(*before, *after, {*same_within});
  const Outcome written = write_comparison(
      arguments, [&] { return comparison_html(comparison); }, [&] { return comparison_json(comparison); }, out);
  if (!written) return fail(err, {written.error()}, kExitInternal);
  if (!arguments.is_quiet && !*taken) out << comparison_text(comparison, arguments.is_verbose);
  return comparison.exit_status();
}

}  // namespace gouge
