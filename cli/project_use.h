#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/project_file.h"

namespace CLI {
class App;
}

namespace gouge {

/// The command line of a `check` or `correct`, with the options that a project file adds.
class ProjectLine {
 public:
  /// `words` is the whole command line, beginning with the program's name. It stays unchanged for another command, for
  /// a wrong command line, and with --no-config. Errors: those of find_project_file.
  [[nodiscard]] static Result<ProjectLine> make(const std::vector<std::string>& words);

  /// Returns the words of the command line. After the command they have the options of the project file that the
  /// command line does not state.
  [[nodiscard]] const std::vector<std::string>& words() const { return words_; }
  /// Returns the use of the project file; none if no file was found, or none of its options is used.
  [[nodiscard]] const std::optional<ProjectUse>& use() const { return use_; }
  /// Returns the error with its place in the project file if it concerns an option from there; other errors unchanged.
  [[nodiscard]] Diagnostic located(const Diagnostic& error) const;

 private:
  void add(const ProjectFile& project, const std::vector<std::string>& typed, const CLI::App& command);

  std::vector<std::string> words_;
  std::vector<ProjectOption> added_;
  std::optional<ProjectUse> use_;
};

/// Adds --no-config to `check` or `correct`.
void add_no_config_option(CLI::App& command, bool& is_without);

/// Returns the long names of the options in `words`, which begins with the name of the command. Returns nothing if they
/// cannot be parsed or request help. Required options may be missing.
[[nodiscard]] std::optional<std::vector<std::string>> options_typed(const std::vector<std::string>& words);

}  // namespace gouge
