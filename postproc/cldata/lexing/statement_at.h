#pragma once

#include <cstddef>

#include "lib/path/toolpath.h"
#include "postproc/cldata/language/statement.h"
#include "postproc/cldata/lexing/lexer.h"

namespace gouge {

/// Returns statement `index` of Toolpath::statements, opened once more in the path's bytes, into which its views point.
/// Of several that stand in the same bytes it is the last one, which holds the position. Without pieces where there is
/// none.
[[nodiscard]] Statement statement_at(const Toolpath& path, std::size_t index, OpenStatements open = &open_text);

}  // namespace gouge
