#pragma once

#include <string>
#include <vector>

#include "lib/base/result.h"
#include "lib/drawing/drawing.h"
#include "lib/field/checked_toolpath.h"
#include "lib/mesh/indexed_mesh.h"
#include "lib/path/toolpath.h"
#include "postproc/image/colour_scale.h"
#include "postproc/image/raster.h"
#include "postproc/image/surface_buffer.h"

namespace gouge {

/// The path of the tool's tip seen from above, from the front and askew, each kind of move in its colour, with
/// the tool axis at some positions, the parts shaded behind it, coordinates along the edges and a scale. Arcs are drawn
/// round; what nothing leads to is not joined. What cannot be seen of a dense path is left out (thin_lines.h), so that a
/// million moves make a few megabytes. `parts` may be empty.
[[nodiscard]] Drawing draw_path(const Toolpath& path, const std::vector<IndexedMesh>& parts);

/// The same as the bytes of a picture. Errors: those of render_png.
[[nodiscard]] Result<std::string> plot_path(const Toolpath& path, const std::vector<IndexedMesh>& parts, bool is_svg);

inline constexpr Colour kCheckedPath{24, 96, 186, 1};
inline constexpr Colour kUncheckedPath{206, 118, 8, 1};

/// Draws where the tip goes while it cuts over a shaded surface, as far as the surface does not hide it: moves that
/// were checked in one colour, those that were not in the other. Where moves lie side by side the surface they cover is
/// coloured. Cost: up to 100,000 moves, spread evenly over longer paths. Requires a toolpath and its result.
void lay_path(Raster& raster, const SurfaceBuffer& buffer, const CheckedToolpath& input);

}  // namespace gouge
