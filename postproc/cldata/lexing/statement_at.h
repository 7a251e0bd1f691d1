#pragma once

#include <cstddef>

#include "lib/path/toolpath.h"
#include "postproc/cldata/language/statement.h"
#include "postproc/cldata/lexing/lexer.h"

namespace gouge {

/// Returns statement `index` of Toolpath::statements, opened once more in the path's bytes, into which its views point.
/// If several statements share these bytes, it is the last one, which has the position. It has no pieces if there is no
/// such statement.
[[nodiscard]] Statement statement_at(const Toolpath& path, std::size_t index, OpenStatements open = &open_text);

}  // namespace gouge
