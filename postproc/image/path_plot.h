#pragma once

#include <string>

#include "lib/base/result.h"
#include "lib/drawing/drawing.h"
#include "lib/path/toolpath.h"

namespace gouge {

/// The path of the tool's tip seen from above, from the front and askew, each kind of move in its colour, with
/// the tool axis at some positions. Arcs are drawn round; what nothing leads to is not joined. What cannot be seen of
/// a dense path is left out (thin_lines.h), so that a million moves make a few megabytes.
[[nodiscard]] Drawing draw_path(const Toolpath& path);

/// The same as the bytes of a picture. Errors: those of render_png.
[[nodiscard]] Result<std::string> plot_path(const Toolpath& path, bool is_svg);

}  // namespace gouge
