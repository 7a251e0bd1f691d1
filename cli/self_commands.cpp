#include "cli/self_commands.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <ostream>

#include "cli/file_schemas.h"
#include "cli/options/command_doc.h"
#include "cli/options/help_text.h"
#include "cli/options/parse_errors.h"
#include "cli/pages/write_completion.h"
#include "cli/pages/write_man.h"
#include "cli/terminal/print_diagnostics.h"
#include "lib/base/exit_code.h"
#include "lib/base/printable_text.h"
#include "lib/base/result.h"
#include "postproc/record/record_schema.h"

namespace gouge {
namespace {

void add_words(CLI::App& command, SelfArguments& arguments) {
  command.add_option("COMMAND", arguments.command, "Command, in one word or two: check, tool import")
      ->type_name("COMMAND");
}

// Returns the command that the words name. Errors: usage, with the word that is not a command.
Result<const CLI::App*> command_called(const CLI::App& app, const std::vector<std::string>& words) {
  const CLI::App* at = &app;
  for (const std::string& word : words) {
    const std::vector<std::string> names = command_names(*at);
    if (std::ranges::find(names, word) == names.end()) {
      const std::string nearest = nearest_name(word, names);
      return make_error("usage", "'" + printable(word) + "' is no command of " + document(*at).name +
                                     (names.empty() ? "" : "; expected " + listed(names, " or ")) + meant(nearest));
    }
    at = at->get_subcommand(word);
  }
  return at;
}

}  // namespace

void add_self_commands(CLI::App& app, SelfArguments& arguments) {
  CLI::App* help = app.add_subcommand("help", "Print the help of a command");
  add_words(*help, arguments);
  help->add_flag("--all")->description(
      "Print all options, as without it; COMMAND --help prints the usual ones of check, correct and batch");
  help->footer("Examples:\n  gougecheck help check --all\n  gougecheck help tool import");
  CLI::App* man = app.add_subcommand("man", "Print the manual page of a command, for man -l -");
  add_words(*man, arguments);
  man->footer("Example:\n  gougecheck man check | man -l -");
  CLI::App* completion = app.add_subcommand("completion", "Print the completion script of a shell");
  completion->add_option("SHELL", arguments.shell, "Name of the shell: bash, zsh or fish")
      ->check(CLI::IsMember({"bash", "zsh", "fish"}))
      ->required();
  completion->footer(
      "Examples:\n"
      "  source <(gougecheck completion bash)\n"
      "  gougecheck completion zsh > ~/.zfunc/_gougecheck\n"
      "  gougecheck completion fish > ~/.config/fish/completions/gougecheck.fish\n\n"
      "The installation of gougecheck includes these scripts.");
  CLI::App* schema = app.add_subcommand("schema", "Print the JSON Schema of a file that the program reads or writes");
  schema
      ->add_option("FILE", arguments.file_kind,
                   "Kind of file: result, the output of --json; project, gougecheck.json; jobs, the job list of a "
                   "batch")
      ->check(CLI::IsMember({"result", "project", "jobs"}))
      ->required();
  schema->footer("Example:\n  gougecheck schema project > gougecheck.schema.json");
}

int run_self_command(const CLI::App& app, const SelfArguments& arguments, std::ostream& out, std::ostream& err) {
  if (app.got_subcommand("completion")) {
    out << write_completion(arguments.shell, document(app));
    return kExitClean;
  }
  if (app.got_subcommand("schema")) {
    const std::string& kind = arguments.file_kind;
    out << (kind == "result" ? result_schema() : kind == "project" ? project_schema() : jobs_schema());
    return kExitClean;
  }
  const Result<const CLI::App*> command = command_called(app, arguments.command);
  if (!command) return fail(err, {command.error()});
  if (app.got_subcommand("man")) {
    out << write_man(document(**command));
  } else {
    // help() of the command cannot be used: it prints the help of the parsed command, which is `help` itself.
    out << app.get_formatter()->make_help(*command, document(**command).name, CLI::AppFormatMode::Normal);
  }
  return kExitClean;
}

}  // namespace gouge
