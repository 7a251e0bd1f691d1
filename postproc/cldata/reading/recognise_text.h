#pragma once

#include <string_view>

#include "postproc/cldata/language/dialect.h"

namespace gouge {

/// Returns the dialect of a text file, by its first lines. A file without the marks of any dialect is plain "apt".
[[nodiscard]] Dialect recognise_text(std::string_view bytes);

}  // namespace gouge
