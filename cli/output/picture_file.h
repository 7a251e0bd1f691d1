#pragma once

#include <string>
#include <vector>

#include "lib/base/result.h"
#include "lib/path/toolpath.h"

namespace gouge {

/// Whether the picture `file` is to be an SVG; else a PNG. Error (code usage) for another ending than .svg and .png, in
/// any case.
[[nodiscard]] Result<bool> is_svg_file(const std::string& file);

/// The note of find_missing_letters (postproc/image/font.h) on the names a picture of this path may show: of the file,
/// its tools and operations, and of `meshes`.
[[nodiscard]] Diagnostics find_missing_letters(const Toolpath& path, const std::vector<std::string>& meshes = {});

}  // namespace gouge
