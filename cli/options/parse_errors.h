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

/// Describes the error of a command line in place of the parser: what was found, what was expected, and
/// where to read on. `app` is the program's, after the parse that failed with `error`; `words` are all of the command
/// line, the program's name first, where there is one. Code: usage.
[[nodiscard]] Diagnostic describe_parse_error(const CLI::App& app, const CLI::ParseError& error,
                                              std::span<const char* const> words = {});

/// Returns what the parser accepted but was not meant, the first of: an empty value ("--csv ''", "--csv="), which is
/// what the unset variable of a script leaves; a value that is the name of another option ("--part --tools t.json"); a
/// file that was read as an option and a rest ("-q1.apt"). `app` is the program's after the parse, also after one that
/// failed; `words` are all of the command line, the program's name first. Code: usage.
[[nodiscard]] std::optional<Diagnostic> find_misread_value(const CLI::App& app, std::span<const char* const> words);

/// The one of `names` that `word` was probably meant to be: the only one it begins, or the nearest by letters that are
/// missing, added, wrong or swapped, the first of equals. Empty where none is near.
[[nodiscard]] std::string nearest_name(std::string_view word, const std::vector<std::string>& names);

}  // namespace gouge
