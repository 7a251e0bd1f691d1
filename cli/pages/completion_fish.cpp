#include "cli/pages/write_completion.h"

namespace gouge {
namespace {

// The function returns the command at the cursor: the last words of the line that are commands.
constexpr const char* kAt = R"(
function __gougecheck_command
    set -l at gougecheck
    for word in (commandline -opc)[2..-1]
        if contains -- "$at $word" $__gougecheck_commands
            set at "$at $word"
        end
    end
    echo $at
end

function __gougecheck_at
    test (__gougecheck_command) = "$argv"
end

complete -c gougecheck -f
)";

std::string fish_quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  return out + "'";
}

std::string fish_words(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

std::string arguments_of(const CommandDoc& program, const OptionDoc& option) {
  std::vector<std::string> words;
  switch (completed_of(option)) {
    case Completed::files:
      return " -F";
    case Completed::folders:
      return " -a '(__fish_complete_directories)'";
    case Completed::choices:
      return " -a " + fish_quoted(fish_words(option.choices));
    case Completed::commands:
      for (const CommandDoc& command : program.commands) words.push_back(command.word());
      return " -a " + fish_quoted(fish_words(words));
    case Completed::nothing:
      break;
  }
  return "";
}

std::string line_of(const CommandDoc& program, const CommandDoc& command, const OptionDoc& option) {
  std::string text = "complete -c gougecheck -n " + fish_quoted("__gougecheck_at " + command.name);
  if (option.is_positional) return text + arguments_of(program, option) + "\n";
  for (const std::string& name : option.names)
    text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  if (!option.value.empty()) text += " -r" + arguments_of(program, option);
  return text + " -d " + fish_quoted(brief_of(option.description)) + "\n";
}

}  // namespace

std::string fish_completion(const CommandDoc& program) {
  std::string names, lines;
  for (const CommandDoc* command : flattened(program)) {
    names += " " + fish_quoted(command->name);
    for (const CommandDoc& one : command->commands) {
      lines += "complete -c gougecheck -n " + fish_quoted("__gougecheck_at " + command->name) + " -a " + one.word() +
               " -d " + fish_quoted(brief_of(one.description)) + "\n";
    }
    for (const OptionDoc& option : command->options) {
      const bool says_something = !option.is_positional || completed_of(option) != Completed::nothing;
      if (says_something) lines += line_of(program, *command, option);
    }
  }
  return "# fish completion of gougecheck, made by: gougecheck completion fish\nset -g __gougecheck_commands" + names +
         "\n" + kAt + lines;
}

}  // namespace gouge
