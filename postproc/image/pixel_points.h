#pragma once

#include <vector>

#include "lib/field/depth_field.h"
#include "lib/field/overcut_field.h"
#include "postproc/image/surface_buffer.h"

namespace gouge {

/// Returns the depth for every pixel of a buffer, mm; 0 where nothing is seen or gouged. Empty where nothing is gouged.
[[nodiscard]] std::vector<float> depth_on_pixels(const DepthField& field, const PictureScene& scene,
                                                 const SurfaceBuffer& buffer);
/// Returns the same of overcuts.
[[nodiscard]] std::vector<float> overcut_on_pixels(const OvercutField& field, const PictureScene& scene,
                                                   const SurfaceBuffer& buffer);

}  // namespace gouge
