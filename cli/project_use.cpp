#include "cli/project_use.h"

#include <algorithm>

#include "cli/options/help_text.h"
#include "cli/program.h"

namespace gouge {
namespace {

bool is_of_project(const std::vector<std::string>& words) {
  return words.size() > 1 && (words[1] == "check" || words[1] == "correct");
}

// Returns the text that reports an option. For files it has only the name; for other options also the value, because
// the verdict depends on it.
std::string told(const ProjectOption& option) {
  constexpr std::string_view kFiles[] = {"part", "fixture", "head", "tools", "stock", "before", "allow-overlap"};
  const bool is_file = std::ranges::find(kFiles, option.key) != std::end(kFiles);
  const std::string value = option.value();
  return is_file || value == "yes" ? option.key : option.key + " " + value;
}

}  // namespace

void add_no_config_option(CLI::App& command, bool& is_without) {
  command.add_flag("--no-config", is_without, std::string("Use no project file (") + kProjectFileName + ")")
      ->group("Input");
}

std::optional<std::vector<std::string>> options_typed(const std::vector<std::string>& words) {
  Program program;
  if (!program.parse_incomplete(words)) return std::nullopt;
  const CLI::App* command = program.app.get_subcommand(words.front());
  std::vector<std::string> typed;
  for (const CLI::Option* option : command->get_options()) {
    if (option->count() == 0 || option->get_lnames().empty()) continue;
    typed.push_back(option->get_lnames().front());
  }
  return typed;
}

Result<ProjectLine> ProjectLine::make(const std::vector<std::string>& words) {
  ProjectLine line;
  line.words_ = words;
  if (!is_of_project(words)) return line;
  const auto typed = options_typed({words.begin() + 1, words.end()});
  if (!typed || std::ranges::find(*typed, kNoConfig) != typed->end()) return line;
  const Result<std::optional<ProjectFile>> found = find_project_file();
  if (!found) return found.error();
  const Program program;
  if (*found) line.add(**found, *typed, *program.app.get_subcommand(words[1]));
  return line;
}

void ProjectLine::add(const ProjectFile& project, const std::vector<std::string>& typed, const CLI::App& command) {
  std::vector<std::string> words;
  for (const ProjectOption& option : project.options) {
    const auto is_typed = [&](const std::string& key) { return std::ranges::find(typed, key) != typed.end(); };
    if (is_typed(option.key) || command.get_option_no_throw("--" + option.key) == nullptr) continue;
    // the option names fixtures of the project file
    if (option.key == "allow-overlap" && is_typed("fixture")) continue;
    words.insert(words.end(), option.words.begin(), option.words.end());
    added_.push_back(option);
  }
  if (added_.empty()) return;
  words_.insert(words_.begin() + 2, words.begin(), words.end());
  std::vector<std::string> parts;
  for (const ProjectOption& option : added_) parts.push_back(told(option));
  const bool is_one = parts.size() == 1;
  use_ = ProjectUse{project.input,
                    listed(parts, " and ") + (is_one ? " comes from " : " come from ") + project.input.name};
}

Diagnostic ProjectLine::located(const Diagnostic& error) const {
  for (const ProjectOption& option : added_) {
    const std::string name = "--" + option.key;
    if (!error.message.starts_with(name)) continue;
    const std::size_t end = name.size();
    if (end < error.message.size() && error.message[end] != ' ' && error.message[end] != ':') continue;
    return make_error("project-option", error.message, use_->input.name, option.line);
  }
  return error;
}

}  // namespace gouge
