#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "postproc/image/colour_scale.h"
#include "postproc/image/raster.h"
#include "postproc/image/surface_buffer.h"

namespace gouge {

/// Shades the surface of a buffer in a soft light, with sharp edges drawn faintly. Untouched surface is grey, gouged
/// surface has the colour of its depth (0: untouched). The list `depth_mm` has one value a pixel or is empty. Four
/// pixels that show one piece of surface, or faces nearly in line, share their light.
[[nodiscard]] Raster shade(const PictureScene& scene, const SurfaceBuffer& buffer, const std::vector<float>& depth_mm,
                           const ColourScale& scale);

/// Returns a level of a colour from a value in [0, 255].
[[nodiscard]] inline std::uint8_t colour_level(double value) { return static_cast<std::uint8_t>(value + 0.5); }

/// A colour to lay over pixels.
class Coat {
 public:
  Coat(const Colour& colour, double opacity)
      : rest_(1 - opacity), paint_{colour.r * opacity, colour.g * opacity, colour.b * opacity} {}
  void lay(std::uint8_t* pixel) const {
    for (std::size_t k = 0; k < 3; ++k) pixel[k] = colour_level(pixel[k] * rest_ + paint_[k]);
  }

 private:
  double rest_;
  std::array<double, 3> paint_;
};

/// Lays `colour` over one pixel.
void blend_pixel(Raster& raster, int x, int y, const Colour& colour, double opacity);

/// Returns how bright a surface is whose unit normal has these parts as a view sees it, 0 to about 1.
[[nodiscard]] double light_on(double right, double up, double toward);

}  // namespace gouge
