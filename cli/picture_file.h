#pragma once

#include <string>

#include "lib/base/result.h"

namespace gouge {

/// Whether the picture `file` is to be an SVG; else a PNG. Error (code usage) for another ending than .svg and .png, in
/// any case.
[[nodiscard]] Result<bool> is_svg_file(const std::string& file);

}  // namespace gouge
