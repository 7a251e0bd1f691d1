#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/project_file.h"

namespace CLI {
class App;
}

namespace gouge {

/// The command line of a `check` or `correct`, with what a project file adds to it.
class ProjectLine {
 public:
  /// `words`: the whole command line, the program's name first. Another command, a command line that is wrong, and
  /// --no-config leave it as it is. Errors: those of find_project_file.
  [[nodiscard]] static Result<ProjectLine> make(const std::vector<std::string>& words);

  /// Returns the words with the options of the project file that the command line does not state, behind the command.
  [[nodiscard]] const std::vector<std::string>& words() const { return words_; }
  /// Returns none where no file was found, or nothing of it is used.
  [[nodiscard]] const std::optional<ProjectUse>& use() const { return use_; }
  /// Returns an error about an option from the file with its place there; others as they are.
  [[nodiscard]] Diagnostic located(const Diagnostic& error) const;

 private:
  void add(const ProjectFile& project, const std::vector<std::string>& typed, const CLI::App& command);

  std::vector<std::string> words_;
  std::vector<ProjectOption> added_;
  std::optional<ProjectUse> use_;
};

/// --no-config of `check` and `correct`.
void add_no_config_option(CLI::App& command, bool& is_without);

/// Returns the long names of the options that `words` gives to a command, its name first. Nothing where they cannot be
/// parsed or request help. Options that are needed may be missing.
[[nodiscard]] std::optional<std::vector<std::string>> options_typed(const std::vector<std::string>& words);

}  // namespace gouge
