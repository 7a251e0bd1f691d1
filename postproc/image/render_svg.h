#pragma once

#include <string>

#include "lib/drawing/drawing.h"

namespace gouge {

/// The drawing as an SVG 1.1 document, one user unit a picture unit.
/// Points that are not finite are left out; text is escaped and keeps its UTF-8.
[[nodiscard]] std::string render_svg(const Drawing& drawing);

}  // namespace gouge
