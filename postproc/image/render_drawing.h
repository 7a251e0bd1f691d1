#pragma once

#include <string>
#include <vector>

#include "lib/base/result.h"
#include "lib/drawing/drawing.h"
#include "postproc/image/raster.h"

namespace gouge {

/// Returns the drawing as the bytes of a PNG file, one pixel for a picture unit, with smoothed lines and text. The same
/// drawing gives the same bytes on every run and with any number of threads. Text is drawn with installed_font
/// (font.h). If no font is installed, it is drawn in stroke letters, which are only ASCII (ascii_text.h).
/// Errors   (1) picture-size: a side is below 1 or above 16384. (2) picture-not-encoded, out-of-memory.
[[nodiscard]] Result<std::string> render_png(const Drawing& drawing);

/// Returns the same with pictures under the drawing, in the given order. Parts outside the drawing are cut off.
[[nodiscard]] Result<std::string> render_png(const Drawing& drawing, const std::vector<PlacedRaster>& underlay);

/// Returns the width of a text in render_png, in picture units.
[[nodiscard]] double text_width(const std::string& text, double size, bool is_bold = false);

/// Returns the drawing as an SVG 1.1 document, one user unit for a picture unit. Points that are not finite are left
/// out. Text is escaped and keeps its UTF-8.
[[nodiscard]] std::string render_svg(const Drawing& drawing);

}  // namespace gouge
