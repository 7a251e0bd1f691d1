#include "cli/pages/write_completion.h"

namespace gouge {
namespace {

constexpr const char* kHead = R"(# bash completion of gougecheck, made by: gougecheck completion bash
_gougecheck() {
  local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD-1]} at=gougecheck kind= words= opts= cmds= i
  COMPREPLY=()
  # "=" is a word of its own here: --rapid = st
  if [[ $cur == = ]]; then
    cur=
  elif [[ $prev == = ]]; then
    prev=${COMP_WORDS[COMP_CWORD-2]}
  fi
  for ((i = 1; i < COMP_CWORD; i++)); do
    case "$at ${COMP_WORDS[i]}" in
)";

constexpr const char* kTail = R"(  esac
  if [[ -z $kind && $cur == -* ]]; then
    kind=choices words=$opts
  fi
  case ${kind:-$place} in
    files) compopt -o filenames; mapfile -t COMPREPLY < <(compgen -f -- "$cur") ;;
    folders) compopt -o filenames; mapfile -t COMPREPLY < <(compgen -d -- "$cur") ;;
    choices) mapfile -t COMPREPLY < <(compgen -W "${words:-$cmds}" -- "$cur") ;;
  esac
}
complete -F _gougecheck gougecheck
)";

std::string bash_words(const std::vector<std::string>& words, const char* between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

std::vector<std::string> words_of(const std::vector<CommandDoc>& commands) {
  std::vector<std::string> words;
  for (const CommandDoc& command : commands) words.push_back(command.word());
  return words;
}

// Returns the line of a case statement that completes the values of an option.
std::string value_case(const OptionDoc& option) {
  std::string text = "        " + bash_words(option.names, "|") + ") ";
  switch (completed_of(option)) {
    case Completed::files:
      return text + "kind=files ;;\n";
    case Completed::folders:
      return text + "kind=folders ;;\n";
    case Completed::choices:
      return text + "kind=choices words=" + single_quoted(bash_words(option.choices, " ")) + " ;;\n";
    case Completed::commands:
    case Completed::nothing:
      break;
  }
  return text + "kind=nothing ;;\n";
}

std::string command_case(const CommandDoc& program, const CommandDoc& command) {
  std::vector<std::string> options, commands = words_of(command.commands);
  std::string values, place = commands.empty() ? "nothing" : "choices";
  for (const OptionDoc& option : command.options) {
    if (!option.is_positional) {
      options.insert(options.end(), option.names.begin(), option.names.end());
      if (!option.value.empty()) values += value_case(option);
      continue;
    }
    const Completed completed = completed_of(option);
    if (completed == Completed::files) place = "files";
    if (completed == Completed::choices) commands = option.choices;
    if (completed == Completed::commands) commands = words_of(program.commands);
    if (!commands.empty()) place = "choices";
  }
  std::string text = "    " + single_quoted(command.name) + ")\n      opts=" + single_quoted(bash_words(options, " ")) +
                     "\n      place=" + place + "\n";
  if (!commands.empty()) text += "      cmds=" + single_quoted(bash_words(commands, " ")) + "\n";
  if (!values.empty()) text += "      case $prev in\n" + values + "      esac\n";
  return text + "      ;;\n";
}

}  // namespace

std::string bash_completion(const CommandDoc& program) {
  std::string text = kHead, cases;
  for (const CommandDoc* command : flattened(program)) {
    if (command != &program)
      text += "      " + single_quoted(command->name) + ") at=" + single_quoted(command->name) + " ;;\n";
    cases += command_case(program, *command);
  }
  return text + "    esac\n  done\n  local place=nothing\n  case $at in\n" + cases + kTail;
}

}  // namespace gouge
