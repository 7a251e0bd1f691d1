#include "cli/config_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <ostream>

#include "cli/options/parse_errors.h"
#include "cli/program.h"
#include "cli/project_use.h"
#include "cli/terminal/length_text.h"
#include "cli/terminal/print_diagnostics.h"
#include "lib/base/exit_code.h"
#include "lib/base/printable_text.h"

namespace gouge {
namespace {

struct ConfigRow {
  std::string key, value, origin;
};

// Returns the row of an option. Both lists together show the origin of each value: the project file and the options
// typed.
ConfigRow row_of(const CLI::Option& option, const ProjectFile* project, const std::vector<std::string>& typed) {
  ConfigRow row{option.get_lnames().front(), {}, {}};
  for (const std::string& value : option.results()) row.value += (row.value.empty() ? "" : ", ") + value;
  if (option.get_items_expected_max() == 0 && option.count() > 0) row.value = "yes";
  if (std::ranges::find(typed, row.key) != typed.end()) {
    row.origin = "command line";
  } else if (option.count() > 0 && project != nullptr && project->option(row.key) != nullptr) {
    row.origin = project->input.name + ":" + std::to_string(project->option(row.key)->line);
  } else {
    row.value = option.get_default_str();
    row.origin = "default";
  }
  return row;
}

std::string table_text(const std::vector<ConfigRow>& rows) {
  std::size_t key = 0, value = 0;
  for (const ConfigRow& row : rows) {
    key = std::max(key, row.key.size());
    value = std::max(value, display_width(printable(row.value)));
  }
  std::string text;
  for (const ConfigRow& row : rows)
    text += padded(row.key, key + 2) + padded(row.value, std::min<std::size_t>(value, 40) + 2) + printable(row.origin) +
            "\n";
  return text;
}

}  // namespace

void add_config_commands(CLI::App& app) {
  CLI::App* config = app.add_subcommand(
      "config", "Show the options in force in this folder and the origin of each, for [check|correct] [OPTIONS]");
  config->prefix_command();
  config->footer(
      "Examples:\n"
      "  gougecheck config\n"
      "  gougecheck config correct --tolerance 0.02\n\n"
      "The project file is gougecheck.json in the working directory or in a folder above it, up to the root of "
      "its repository. The command line overrides the file, and the file overrides the default.");
  CLI::App* init = app.add_subcommand(
      "init", "Write gougecheck.json from the files in this folder, or from the given options of check");
  init->prefix_command();
  init->footer(
      "Examples:\n"
      "  gougecheck init\n"
      "  gougecheck init --part part.stl --tolerance 0.02\n\n"
      "Part, fixtures, heads and tool library are recognized by the names of their files. An existing file is "
      "never replaced. If nothing is found and no option is given, no file is written (exit status 3).");
}

int run_config(const std::vector<std::string>& words, std::ostream& out, std::ostream& err) {
  std::vector<std::string> line = {"gougecheck"};
  const bool names_command = !words.empty() && (words.front() == "check" || words.front() == "correct");
  if (!names_command && !words.empty() && !words.front().starts_with('-'))
    return fail(err, {usage_error("config", words.front(), "check, correct or options")});
  if (!names_command) line.emplace_back("check");
  line.insert(line.end(), words.begin(), words.end());
  const Result<ProjectLine> used = ProjectLine::make(line);
  if (!used) return fail(err, {used.error()});
  const Result<std::optional<ProjectFile>> found = find_project_file();
  if (!found) return fail(err, {found.error()});
  Program program;
  CLI::App& command = *program.app.get_subcommand(line[1]);
  for (CLI::Option* option : command.get_options()) option->required(false);
  std::vector<std::string> reversed(used->words().rbegin(), used->words().rend());
  reversed.pop_back();
  try {
    program.app.parse(std::move(reversed));
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return program.app.exit(error, out, err);
    return fail(err, {used->located(describe_parse_error(program.app, error))});
  }
  const auto typed = options_typed({line.begin() + 1, line.end()});
  const ProjectFile* project = *found && used->use() ? &**found : nullptr;
  std::vector<ConfigRow> rows;
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_lnames().empty() || option->get_group() == kTerminalGroup) continue;
    const ConfigRow row = row_of(*option, project, typed.value_or(std::vector<std::string>{}));
    if (!row.value.empty()) rows.push_back(row);
  }
  out << "project file: "
      << (project != nullptr ? printable(project->input.name)
          : *found           ? "found, not used"
                             : "none")
      << "\n"
      << table_text(rows);
  return kExitClean;
}

}  // namespace gouge
