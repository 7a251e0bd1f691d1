#pragma once

#include "lib/check/check_result.h"
#include "lib/path/toolpath.h"
#include "postproc/image/colour_scale.h"
#include "postproc/image/raster.h"
#include "postproc/image/surface_buffer.h"

namespace gouge {

inline constexpr Colour kCheckedPath{24, 96, 186, 1};
inline constexpr Colour kUncheckedPath{206, 118, 8, 1};

/// Draws where the tip goes while it cuts over a shaded surface, as far as the surface does not hide it: moves that
/// were checked in one colour, those that were not in the other. Where moves lie side by side the surface they cover is
/// coloured. Cost: up to 100,000 moves, spread evenly over longer paths.
void lay_path(Raster& raster, const SurfaceBuffer& buffer, const Toolpath& path, const CheckResult& result);

}  // namespace gouge
