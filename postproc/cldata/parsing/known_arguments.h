#pragma once

#include <span>
#include <string_view>

#include "postproc/cldata/language/arguments.h"
#include "postproc/cldata/language/statement.h"
#include "postproc/cldata/language/words.h"

// Statements hidden in another one: two on a line, or a `$` too many before a line that begins one.

namespace gouge {

/// Returns true where the reader of `word` knows every argument, or examines all of them itself. Text in single quotes
/// is a name. One that is not known may change what the statement means, or belong to a statement that was joined to
/// it.
[[nodiscard]] bool are_known_arguments(Word word, std::span<const Argument> arguments);

/// Returns the first word within `statement` that begins another one which moves the tool or changes what motion means;
/// empty where there is none. Text and comments hold none, only the lines that continue a comment with data may.
[[nodiscard]] std::string_view find_run_on(const Statement& statement);

}  // namespace gouge
