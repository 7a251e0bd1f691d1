#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <variant>
#include <vector>

#include "cli/check_command.h"
#include "cli/correct_options.h"
#include "lib/base/result.h"

namespace gouge {

using CommandArguments = std::variant<CheckArguments, CorrectArguments>;

/// The options of `check` or `correct` as the values of a job list give them.
class JobWords {
 public:
  /// `command`: "check" or "correct". `folder`: that relative files are below; empty: the working directory.
  JobWords(std::string command, std::string folder) : command_(std::move(command)), folder_(std::move(folder)) {}

  /// Adds "--key=value" for a text or a number, one for each entry of a list, and "--key" for a flag that is true.
  /// Errors: jobs-option, without a file, naming the key: one the command does not have or that belongs to the batch, or
  /// a value of the wrong kind.
  [[nodiscard]] Outcome add(const std::string& key, const nlohmann::json& value);
  /// `file` below the folder, if it is relative.
  [[nodiscard]] std::string located(const std::string& file) const;
  [[nodiscard]] const std::vector<std::string>& words() const { return words_; }

 private:
  std::string command_, folder_;
  std::vector<std::string> words_;
};

/// Parses and understands `words` as the command line of `command`. Errors: usage, as the program says it.
[[nodiscard]] Result<CommandArguments> parse_command(const std::string& command, const std::vector<std::string>& words);

}  // namespace gouge
