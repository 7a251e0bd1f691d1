#include "cli/run.h"

#include <CLI/CLI.hpp>
#include <cstdint>
#include <exception>
#include <new>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "cli/batch/batch_command.h"
#include "cli/commands/accept_command.h"
#include "cli/commands/correct_command.h"
#include "cli/config_command.h"
#include "cli/failed_line.h"
#include "cli/options/help_text.h"
#include "cli/options/length_rule.h"
#include "cli/options/parse_errors.h"
#include "cli/options/short_help.h"
#include "cli/program.h"
#include "cli/project_use.h"
#include "cli/short_line.h"
#include "cli/terminal/print_diagnostics.h"
#include "cli/terminal/terminal.h"
#include "lib/base/exit_code.h"
#include "lib/base/parallel.h"
#include "lib/base/printable_text.h"

namespace gouge {
namespace {

/// Applies --threads to the whole command. Returns false if the number is too large.
bool set_threads(const CLI::App& app, const Arguments& arguments, std::ostream& err) {
  std::uint64_t threads = 0;
  if (app.got_subcommand("check")) threads = arguments.check.job.threads;
  if (app.got_subcommand("correct")) threads = arguments.correct.job.threads;
  if (app.got_subcommand("batch")) threads = arguments.batch.check.job.threads;
  if (app.got_subcommand("mesh")) threads = arguments.mesh.threads;
  if (app.got_subcommand("verify")) threads = arguments.verify.threads;
  if (threads > kMaxThreads) {
    print(err, {make_error("too-many-threads", "--threads '" + std::to_string(threads) + "': expected at most " +
                                                   std::to_string(kMaxThreads) + ", or 0 for all the machine has")});
    return false;
  }
  set_default_threads(static_cast<unsigned>(threads));
  return true;
}

/// Tells the command about its project file. An error in a value from that file is found here, where its line is known.
std::optional<Diagnostic> take_project(const ProjectLine& line, const CLI::App& app, Arguments& arguments) {
  const bool is_check = app.got_subcommand("check");
  JobArguments& job = is_check ? arguments.check.job : arguments.correct.job;
  job.project_file = line.use();
  const std::optional<Diagnostic> wrong =
      is_check ? find_wrong_value(arguments.check) : find_wrong_value(arguments.correct);
  return wrong ? std::optional(line.located(*wrong)) : std::nullopt;
}

std::vector<const char*> pointers_to(const std::vector<std::string>& words) {
  std::vector<const char*> pointers;
  for (const std::string& word : words) pointers.push_back(word.c_str());
  return pointers;
}

int dispatch(const CLI::App& app, const Arguments& arguments, std::ostream& out, std::ostream& err) {
  if (!set_threads(app, arguments, err)) return kExitUsage;
  if (app.got_subcommand("check")) return run_check(arguments.check, {out, err});
  if (app.got_subcommand("correct")) return run_correct(arguments.correct, {out, err});
  if (app.got_subcommand("batch")) return run_batch(arguments.batch, out, err);
  if (app.got_subcommand("clash")) return run_clash(arguments.clash, out, err);
  if (app.got_subcommand("accept")) return run_accept(arguments.accept, out, err);
  if (app.got_subcommand("compare")) return run_compare(arguments.compare, out, err);
  if (app.got_subcommand("merge")) return run_merge(arguments.merge, out, err);
  if (app.got_subcommand("machine")) return run_machine(arguments.machine, out, err);
  if (app.got_subcommand("mesh")) return run_mesh(arguments.mesh, out, err);
  if (app.got_subcommand("tool")) return run_tool(arguments.tool, out, err);
  if (app.got_subcommand("path")) return run_path(arguments.path, out, err);
  if (app.got_subcommand("config")) return run_config(app.get_subcommand("config")->remaining(), out, err);
  if (app.got_subcommand("init")) return run_init(app.get_subcommand("init")->remaining(), out, err);
  if (app.got_subcommand("verify")) return run_verify(arguments.verify, out, err);
  return run_self_command(app, arguments.self, out, err);
}

// Prints the short page of a command that has one.
bool print_short_help(const CLI::App& app, const HelpColumns& columns, std::ostream& out) {
  const std::vector<CLI::App*> commands = app.get_subcommands();
  const std::string text = commands.empty() ? "" : short_help(*commands.back(), columns);
  out << text;
  return !text.empty();
}

// Returns the status after output. Printed text may end early (`| head -1`), but undelivered data is a failure, which
// its command has reported.
int after_printing(int status, const std::vector<std::string>& words, std::ostream& out, std::ostream& err) {
  out.flush();
  if (out || status == kExitInternal || is_reader_gone()) return status;
  const Diagnostic error = describe_failed_output();
  print(err, {error});
  write_failure_of(words, error, kExitInternal, out, err);
  return kExitInternal;
}

// Gives the arguments of the command that is run what the whole command line states.
void complete_arguments(const CLI::App& app, Arguments& arguments) {
  if (app.got_subcommand("batch")) take_words(*app.get_subcommand("batch"), arguments.batch);
  for (const auto& [name, job] : {std::pair("check", &arguments.check.job), {"correct", &arguments.correct.job}}) {
    if (!app.got_subcommand(name)) continue;
    job->command = repeatable_command(*app.get_subcommand(name));
    job->lengths_in_mm = lengths_in_mm(*app.get_subcommand(name));
  }
  if (app.got_subcommand("clash")) arguments.clash.lengths_in_mm = lengths_in_mm(*app.get_subcommand("clash"));
  if (app.got_subcommand("mesh")) arguments.mesh.lengths_in_mm = lengths_in_mm(*app.get_subcommand("mesh"));
}

// Runs the command line `words`, and replaces them by what they mean as soon as it is known.
int run_words(std::vector<std::string>& words, std::ostream& out, std::ostream& err) {
  const HelpColumns columns(terminal_columns(out));
  Program program(columns);
  CLI::App& app = program.app;
  choose_colour(err, "auto");
  ShortLine typed = expand_short_line(words, command_names(app));
  words = std::move(typed.words);
  // A wrong option is reported first, and help is printed all the same.
  if (typed.error && options_typed({words.begin() + 1, words.end()})) return fail_line(words, *typed.error, out, err);
  const Result<ProjectLine> line = ProjectLine::make(words);
  if (!line) return fail_line(words, line.error(), out, err);
  try {
    std::vector<std::string> reversed(line->words().rbegin(), line->words().rend());
    if (!reversed.empty()) reversed.pop_back();  // drops the program's name
    app.parse(std::move(reversed));
  } catch (const CLI::ParseError& error) {
    choose_colour(err, program.colour());
    if (dynamic_cast<const CLI::CallForHelp*>(&error) != nullptr && print_short_help(app, columns, out))
      return after_printing(kExitClean, words, out, err);
    // CLI11 reports --help and --version as errors of status 0.
    if (error.get_exit_code() == 0) return after_printing(app.exit(error, out, err), words, out, err);
    const std::vector<const char*> pointers = pointers_to(words);
    if (const std::optional<Diagnostic> empty = find_misread_value(app, pointers)) return fail(err, {*empty});
    return fail_line(words, line->located(describe_parse_error(app, error, pointers)), out, err);
  }
  if (const std::optional<Diagnostic> empty = find_misread_value(app, pointers_to(words))) return fail(err, {*empty});
  choose_colour(out, program.colour());
  choose_colour(err, program.colour());
  if (line->use()) {
    if (const std::optional<Diagnostic> wrong = take_project(*line, app, program.arguments))
      return fail_line(line->words(), *wrong, out, err);
  }
  complete_arguments(app, program.arguments);
  return after_printing(dispatch(app, program.arguments, out, err), words, out, err);
}

}  // namespace

int run(int argc, const char* const* argv, std::ostream& out, std::ostream& err) {
  std::vector<std::string> words;
  std::optional<Diagnostic> error;
  try {
    words.assign(argv, argv + argc);
    return run_words(words, out, err);
  } catch (const std::bad_alloc&) {
    err << "gougecheck: error: out of memory; nothing more was written [out-of-memory]\n";
    error = make_error("out-of-memory", "out of memory");
  } catch (const std::exception& failure) {
    err << "gougecheck: error: internal failure: " << printable(failure.what()) << " [internal]\n";
    error = make_error("internal", std::string("internal failure: ") + failure.what());
  }
  try {
    write_failure_of(words, *error, kExitInternal, out, err);
  } catch (const std::exception&) {
    // The error is already printed.
  }
  return kExitInternal;
}

}  // namespace gouge
