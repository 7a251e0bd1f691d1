#pragma once

#include <vector>

#include "lib/field/depth_field.h"
#include "lib/field/overcut_field.h"
#include "postproc/image/surface_buffer.h"

namespace gouge {

/// Returns the depth in mm for every pixel of a buffer: 0 where the pixel shows no surface or no gouge. Returns an
/// empty vector if the field has no gouge.
[[nodiscard]] std::vector<float> depth_on_pixels(const DepthField& field, const PictureScene& scene,
                                                 const SurfaceBuffer& buffer);
/// Returns the same for overcuts.
[[nodiscard]] std::vector<float> overcut_on_pixels(const OvercutField& field, const PictureScene& scene,
                                                   const SurfaceBuffer& buffer);

}  // namespace gouge
