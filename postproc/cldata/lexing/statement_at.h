#pragma once

#include <cstddef>

#include "lib/path/toolpath.h"
#include "postproc/cldata/language/statement.h"

namespace gouge {

/// Statement `index` of Toolpath::statements, read once more from the path's bytes, into which its views
/// point. Of a pair of lines of Mastercam NCI, which says several statements, the position. Without pieces
/// where there is none.
[[nodiscard]] Statement statement_at(const Toolpath& path, std::size_t index);

}  // namespace gouge
