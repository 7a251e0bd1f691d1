#pragma once

#include <string_view>

#include "postproc/cldata/language/statement.h"

// Statements hidden in another one: two on a line, or a `$` too many before a line that begins one.

namespace gouge {

/// The first word within `statement` that begins another one which moves the tool or changes what motion means; empty
/// where there is none. Text and comments hold none, only the lines that continue a comment with data may.
[[nodiscard]] std::string_view find_run_on(const Statement& statement);

}  // namespace gouge
