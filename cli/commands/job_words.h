#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "cli/commands/check_command.h"
#include "cli/options/correct_options.h"
#include "lib/base/result.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace gouge {

using CommandArguments = std::variant<CheckArguments, CorrectArguments>;

/// Options that a file may set, and the codes of its errors.
struct WordRules {
  std::string error_code;
  /// Returns why a file cannot set an option of the command; nothing if it can.
  std::optional<std::string> (*why_not)(const CLI::Option& option);
  std::string why_no_dash;  ///< why a file of a job cannot be -
};
/// Returns the rules of a job list.
[[nodiscard]] const WordRules& job_rules();

/// Returns the table of options of "check" or "correct" that a file may set.
[[nodiscard]] const CLI::App& option_table(const std::string& command);

/// Returns the long name of the option that `key` of a file sets. Both are equal, except `harmless_words` for
/// --harmless-word.
[[nodiscard]] std::string option_of_key(const std::string& key);
/// Returns the key of a file for the long name of an option.
[[nodiscard]] std::string key_of_option(const std::string& name);

/// The options of `check` or `correct`, built from the values of a job list or a project file.
class JobWords {
 public:
  /// `command` is "check" or "correct". `folder` is the folder of relative files; empty: the working directory.
  JobWords(std::string command, std::string folder, const WordRules& rules = job_rules())
      : command_(std::move(command)), folder_(std::move(folder)), rules_(&rules) {}

  /// Adds "--key=value" for a text or a number, one for each entry of a list, and "--key" for a flag that is true. An
  /// option whose value depends on the body may be an object: {"shank": 0.5, "holder": 1}.
  /// Errors: the code of the rules, without a file, with the key. The command does not have the option, a file must not
  /// set it, or its value is of the wrong kind.
  [[nodiscard]] Outcome add(const std::string& key, const nlohmann::json& value);
  /// Returns `file` below the folder if it is relative.
  [[nodiscard]] std::string located(const std::string& file) const;
  /// Locates both files of the text of --before.
  [[nodiscard]] std::string located_before(const std::string& typed) const;
  [[nodiscard]] const std::vector<std::string>& words() const { return words_; }

 private:
  [[nodiscard]] Diagnostic wrong(const std::string& message) const;
  [[nodiscard]] Diagnostic unknown(const std::string& key) const;
  [[nodiscard]] Outcome add_by_body(const std::string& key, const nlohmann::json& value);

  std::string command_, folder_;
  const WordRules* rules_;
  std::vector<std::string> words_;
};

/// Parses and understands `words` as the command line of `command`. Errors: usage, with the text of the program.
[[nodiscard]] Result<CommandArguments> parse_command(const std::string& command, const std::vector<std::string>& words);

}  // namespace gouge
