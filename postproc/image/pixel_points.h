#pragma once

#include <cstdint>
#include <vector>

#include "lib/field/depth_field.h"
#include "lib/field/overcut_field.h"
#include "postproc/image/surface_buffer.h"

namespace gouge {

/// The surface points a picture is coloured by: one for neighbouring pixels (2 x 2) that lie on one piece of
/// surface. Neighbours in the list are neighbours in the picture.
struct PixelPoints {
  std::vector<std::uint32_t>
      pixels;  ///< of each point: it lies in the middle of this one, the first of those it is for
  std::vector<std::uint32_t> source;  ///< by pixel: its point, kNoFace where nothing is seen

  /// A value for every pixel from one for every point; 0 where nothing is seen.
  [[nodiscard]] std::vector<float> spread(const std::vector<float>& values) const;
};

[[nodiscard]] PixelPoints pixel_points(const SurfaceBuffer& buffer);

/// The depth for every pixel of a buffer, mm; 0 where nothing is seen or gouged.
[[nodiscard]] std::vector<float> depth_on_pixels(const DepthField& field, const PictureScene& scene,
                                                 const SurfaceBuffer& buffer);
/// The same of overcuts.
[[nodiscard]] std::vector<float> overcut_on_pixels(const OvercutField& field, const PictureScene& scene,
                                                   const SurfaceBuffer& buffer);

}  // namespace gouge
