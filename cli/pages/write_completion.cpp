#include "cli/pages/write_completion.h"

namespace gouge {

std::string write_completion(const std::string& shell, const CommandDoc& program) {
  if (shell == "zsh") return zsh_completion(program);
  return shell == "fish" ? fish_completion(program) : bash_completion(program);
}

Completed completed_of(const OptionDoc& option) {
  if (!option.choices.empty()) return Completed::choices;
  if (option.takes_file()) return Completed::files;
  if (option.takes_folder()) return Completed::folders;
  return option.value == "COMMAND" ? Completed::commands : Completed::nothing;
}

std::vector<const CommandDoc*> flattened(const CommandDoc& program) {
  std::vector<const CommandDoc*> all = {&program};
  for (const CommandDoc& command : program.commands) {
    for (const CommandDoc* below : flattened(command)) all.push_back(below);
  }
  return all;
}

std::string single_quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

std::string brief_of(const std::string& description) {
  constexpr std::size_t kMost = 72;
  std::size_t end = description.size();
  for (const char* stop : {"; ", ": ", " (", ". ", "\n"}) end = std::min(end, description.find(stop));
  if (end > kMost) end = description.rfind(' ', kMost);
  return description.substr(0, end);
}

}  // namespace gouge
