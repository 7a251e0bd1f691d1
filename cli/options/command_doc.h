#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

// The tables of options as plain data: help, manual pages and completions are made of it.

namespace gouge {

/// Type of an option that takes a dialect which can be written; "DIALECT" takes any. Help shows both as DIALECT.
inline constexpr const char* kWritableDialect = "WRITABLE-DIALECT";

/// Returns the choices of "TEXT:{straight,dogleg,skip}", as the parser names a text of few values; empty for anything
/// else.
[[nodiscard]] std::vector<std::string> choices_in(const std::string& text);

/// Returns the choices of an option with that type: dialects, or those of choices_in.
[[nodiscard]] std::vector<std::string> choices_of_type(const std::string& type);

struct OptionDoc {
  std::vector<std::string> names;    ///< "-o", "--output"; of a positional its one name
  std::string value;                 ///< "FILE", "LENGTH", "auto|always|never"; empty: it takes none
  std::vector<std::string> choices;  ///< all values it takes, where they are few
  std::string description, default_value, group;
  std::vector<std::string> needs;  ///< options without which it may not be given
  bool is_positional = false, is_required = false, is_repeatable = false;

  /// Returns the description, with "[default: 0.01]" and "[required]" where it is so.
  [[nodiscard]] std::string full_description() const;
  [[nodiscard]] bool takes_file() const;
  [[nodiscard]] bool takes_folder() const { return value == "FOLDER"; }
};
[[nodiscard]] OptionDoc document(const CLI::Option& option);

struct CommandDoc {
  std::string name;  ///< with those above it: "gougecheck tool import"
  std::string description, footer;
  std::vector<OptionDoc> options;  ///< positionals first
  std::vector<CommandDoc> commands;

  /// Returns the command's own word: "import".
  [[nodiscard]] std::string word() const;
};
/// Returns `app` and all commands below it.
[[nodiscard]] CommandDoc document(const CLI::App& app);

}  // namespace gouge
