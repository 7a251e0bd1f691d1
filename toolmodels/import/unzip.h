#pragma once

#include <string>
#include <string_view>

#include "lib/base/result.h"

namespace gouge {

[[nodiscard]] bool is_zip(std::string_view bytes);

/// The first file of the archive whose name ends in `ending`. Errors: import-zip (also for one larger than
/// 256 MB, which no library is).
[[nodiscard]] Result<std::string> unzip_first(const std::string& file, std::string_view bytes, std::string_view ending);

}  // namespace gouge
