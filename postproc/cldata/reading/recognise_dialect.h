#pragma once

#include <string_view>

#include "postproc/cldata/language/dialect.h"

namespace gouge {

/// Looks at the first lines only. A file without the marks of any dialect is plain "apt".
[[nodiscard]] Dialect recognise_dialect(std::string_view bytes);

}  // namespace gouge
