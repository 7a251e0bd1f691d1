#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/diagnostic.h"

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace gouge {

/// Describes the error of a command line in place of the parser: what was found, what was expected, and where to read
/// on. The `app` is the program's, after the parse that failed with `error`. All words of the command line are in
/// `words`, the program's name first, where there is one. Code: usage.
[[nodiscard]] Diagnostic describe_parse_error(const CLI::App& app, const CLI::ParseError& error,
                                              std::span<const char* const> words = {});

/// Returns the first value that the parser accepted but that was not meant. (1) An empty value ("--csv ''", "--csv="),
/// as the unset variable of a script leaves. (2) A value that is the name of another option ("--part --tools t.json").
/// (3) A file that was read as an option and a rest ("-q1.apt"). The `app` is the program's after the parse, also after
/// one that failed. All words of the command line are in `words`, the program's name first. Code: usage.
[[nodiscard]] std::optional<Diagnostic> find_misread_value(const CLI::App& app, std::span<const char* const> words);

/// Returns the names of the commands directly below `app`.
[[nodiscard]] std::vector<std::string> command_names(const CLI::App& app);

/// Returns the one of `names` that `word` was probably meant to be. It is the only one that `word` begins, that ends with
/// it, or that has a part which `word` begins. Else it is the nearest by letters that are missing, added, wrong or
/// swapped. Of equals it is the first. Empty where none is near.
[[nodiscard]] std::string nearest_name(std::string_view word, const std::vector<std::string>& names);

/// Returns "; did you mean --part?"; empty for an empty name.
[[nodiscard]] std::string meant(const std::string& name);

}  // namespace gouge
