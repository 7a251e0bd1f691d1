#pragma once

#include <cstdint>
#include <vector>

#include "lib/field/depth_field.h"
#include "lib/field/overcut_field.h"
#include "postproc/image/surface_buffer.h"

namespace gouge {

/// A surface point that a picture is coloured by: one for neighbouring pixels (2 x 2) that lie on one piece of surface.
struct PixelPoint {
  int x = 0, y = 0;  ///< it lies in the middle of this pixel, the first of those it is for
  /// Of the square of 2 x 2 pixels that has this one, those it is for: bit x + 2 y.
  std::uint8_t covers = 0;
};

/// The points of all pixels that show a face. Neighbours in the list are neighbours in the picture.
[[nodiscard]] std::vector<PixelPoint> pixel_points(const SurfaceBuffer& buffer);

/// A value for every pixel from one for every point; 0 where nothing is seen. Empty where all are 0.
[[nodiscard]] std::vector<float> spread(const SurfaceBuffer& buffer, const std::vector<PixelPoint>& points,
                                        const std::vector<float>& values);

/// The depth for every pixel of a buffer, mm; 0 where nothing is seen or gouged. Empty where nothing is gouged.
[[nodiscard]] std::vector<float> depth_on_pixels(const DepthField& field, const PictureScene& scene,
                                                 const SurfaceBuffer& buffer);
/// The same of overcuts.
[[nodiscard]] std::vector<float> overcut_on_pixels(const OvercutField& field, const PictureScene& scene,
                                                   const SurfaceBuffer& buffer);

}  // namespace gouge
