#pragma once

#include <vector>

#include "postproc/image/colour_scale.h"
#include "postproc/image/raster.h"
#include "postproc/image/surface_buffer.h"

namespace gouge {

/// The surface of a buffer in a soft light, untouched surface in grey and gouged ones in the colour of their
/// depth (0: untouched), with sharp edges drawn faintly. `depth_mm` has one value a pixel or is empty. Four pixels that
/// show one piece of surface, or faces nearly in line, share their light.
[[nodiscard]] Raster shade(const PictureScene& scene, const SurfaceBuffer& buffer, const std::vector<float>& depth_mm,
                           const ColourScale& scale);

/// Lays `colour` over one pixel.
void blend_pixel(Raster& raster, int x, int y, const Colour& colour, double opacity);

/// How bright a surface is whose unit normal has these parts as a view sees it, 0 to about 1.
[[nodiscard]] double light_on(double right, double up, double toward);

}  // namespace gouge
