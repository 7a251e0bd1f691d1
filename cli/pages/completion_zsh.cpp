#include <algorithm>

#include "cli/pages/write_completion.h"

namespace gouge {
namespace {

// Escapes brackets and colons, which end a part of a spec of _arguments.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') out += '\\';
    out += c;
  }
  return out;
}

std::string action_of(const CommandDoc& program, const OptionDoc& option) {
  std::string words;
  switch (completed_of(option)) {
    case Completed::files:
      return "_files";
    case Completed::folders:
      return "_files -/";
    case Completed::choices:
      for (const std::string& choice : option.choices) words += (words.empty() ? "" : " ") + choice;
      return "(" + words + ")";
    case Completed::commands:
      for (const CommandDoc& command : program.commands) words += (words.empty() ? "" : " ") + command.word();
      return "(" + words + ")";
    case Completed::nothing:
      break;
  }
  return " ";
}

std::string function_of(const CommandDoc& command) {
  std::string name = "_" + command.name;
  std::ranges::replace(name, ' ', '_');
  return name;
}

std::string value_spec(const CommandDoc& program, const OptionDoc& option) {
  return ":" + escaped(option.value) + ":" + action_of(program, option);
}

std::vector<std::string> specs_of(const CommandDoc& program, const OptionDoc& option) {
  if (option.is_positional) return {(option.is_repeatable ? "*" : "") + value_spec(program, option)};
  std::vector<std::string> specs;
  for (const std::string& name : option.names) {
    std::string spec = option.is_repeatable ? "*" : "";
    if (!option.is_repeatable && option.names.size() > 1) {
      spec += "(";
      for (const std::string& other : option.names) spec += (spec.back() == '(' ? "" : " ") + other;
      spec += ")";
    }
    spec += name;
    if (!option.value.empty() && name.starts_with("--")) spec += "=";
    spec += "[" + escaped(brief_of(option.description)) + "]";
    if (!option.value.empty()) spec += value_spec(program, option);
    specs.push_back(spec);
  }
  return specs;
}

std::string function_text(const CommandDoc& program, const CommandDoc& command) {
  std::string text = function_of(command) + "() {\n";
  const bool leads_on = !command.commands.empty();
  if (leads_on) {
    text += "  local state line\n  local -a commands=(\n";
    for (const CommandDoc& one : command.commands)
      text += "    " + single_quoted(one.word() + ":" + escaped(brief_of(one.description))) + "\n";
    text += "  )\n";
  }
  text += std::string("  _arguments -s") + (leads_on ? " -C" : "");
  for (const OptionDoc& option : command.options) {
    for (const std::string& spec : specs_of(program, option)) text += " \\\n    " + single_quoted(spec);
  }
  if (!leads_on) return text + "\n}\n\n";
  text += " \\\n    '1: :->command' \\\n    '*:: :->rest'\n  case $state in\n";
  text += "    command) _describe command commands ;;\n    rest)\n      case $words[1] in\n";
  for (const CommandDoc& one : command.commands) text += "        " + one.word() + ") " + function_of(one) + " ;;\n";
  return text + "      esac\n      ;;\n  esac\n}\n\n";
}

}  // namespace

std::string zsh_completion(const CommandDoc& program) {
  std::string text = "#compdef gougecheck\n# made by: gougecheck completion zsh\n\n";
  for (const CommandDoc* command : flattened(program)) text += function_text(program, *command);
  return text +
         "if [ \"$funcstack[1]\" = \"_gougecheck\" ]; then\n  _gougecheck \"$@\"\nelse\n  compdef _gougecheck gougecheck\nfi\n";
}

}  // namespace gouge
