#pragma once

#include <string>
#include <vector>

#include "lib/base/result.h"
#include "lib/check/check_result.h"
#include "lib/drawing/drawing.h"
#include "lib/mesh/indexed_mesh.h"
#include "lib/path/toolpath.h"
#include "postproc/image/colour_scale.h"
#include "postproc/image/raster.h"
#include "postproc/image/surface_buffer.h"

namespace gouge {

/// Draws the path of the tip in top view, front view and isometric view, each kind of move in its colour. The drawing
/// shows the tool axis at some positions, the parts shaded behind it, coordinates along the edges and a scale. Arcs are
/// drawn round. A move without a start is not joined. Lines of a dense path that cannot be seen are left out
/// (thin_lines.h), so that a million moves make a few megabytes. The list `parts` may be empty.
[[nodiscard]] Drawing draw_path(const Toolpath& path, const std::vector<IndexedMesh>& parts);

/// Returns the same as the bytes of a picture. Errors: those of render_png.
[[nodiscard]] Result<std::string> plot_path(const Toolpath& path, const std::vector<IndexedMesh>& parts, bool is_svg);

inline constexpr Colour kCheckedPath{24, 96, 186, 1};
inline constexpr Colour kUncheckedPath{206, 118, 8, 1};

/// Draws where the tip goes while it cuts over a shaded surface, as far as the surface does not hide it. Moves that
/// were checked have one colour, those that were not the other. Where moves lie side by side the surface they cover is
/// coloured. Cost: up to 100,000 moves, spread evenly over longer paths.
void lay_path(Raster& raster, const SurfaceBuffer& buffer, const Toolpath& path, const CheckResult& result);

}  // namespace gouge
