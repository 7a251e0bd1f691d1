#pragma once

#include <span>
#include <string_view>

#include "postproc/cldata/language/arguments.h"
#include "postproc/cldata/language/statement.h"
#include "postproc/cldata/language/words.h"

// Finds statements that are hidden in another one: two on a line, or one after a superfluous `$`.

namespace gouge {

/// Returns whether the reader of `word` knows every argument, or examines all of them itself. Text in single quotes is
/// a name. An unknown argument may change the meaning of the statement, or belong to a statement that was joined to it.
[[nodiscard]] bool are_known_arguments(Word word, std::span<const Argument> arguments);

/// Returns the first word within `statement` that begins another one which moves the tool or changes the meaning of
/// motion; empty if there is none. Text and comments are not searched, except the lines that continue a comment with
/// data.
[[nodiscard]] std::string_view find_run_on(const Statement& statement);

}  // namespace gouge
