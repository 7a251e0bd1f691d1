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

/// Draws the path of the tool's tip in top view, front view and isometric view, each kind of move in its colour. It
/// shows the tool axis at some positions, the shaded parts behind the path, coordinates along the edges and a scale.
/// Arcs are drawn as curves. A move without a start has no line to it. Invisible lines of a dense path are left out
/// (thin_lines.h), so that a million moves give a few megabytes. `parts` may be empty.
[[nodiscard]] Drawing draw_path(const Toolpath& path, const std::vector<IndexedMesh>& parts);

/// Returns the plot as the bytes of a picture. Errors: those of render_png.
[[nodiscard]] Result<std::string> plot_path(const Toolpath& path, const std::vector<IndexedMesh>& parts, bool is_svg);

inline constexpr Colour kCheckedPath{24, 96, 186, 1};
inline constexpr Colour kUncheckedPath{206, 118, 8, 1};

/// Draws the path of the tip while it cuts over a shaded surface, where the surface does not hide it. Checked moves
/// have one colour, unchecked moves another. Where moves lie side by side, they colour the surface that they cover.
/// Cost: up to 100,000 moves, evenly distributed over longer paths. Requires a toolpath and its result.
void lay_path(Raster& raster, const SurfaceBuffer& buffer, const CheckedToolpath& input);

}  // namespace gouge
