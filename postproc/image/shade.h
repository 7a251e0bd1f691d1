#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "postproc/image/colour_scale.h"
#include "postproc/image/raster.h"
#include "postproc/image/surface_buffer.h"

namespace gouge {

/// Shades the surface of a buffer in a soft light, with faint lines at sharp edges. Untouched surface is grey, and
/// gouged surface has the colour of its depth (0: untouched; negative: material is left). `depth_mm` has one value for each pixel or is empty. Four
/// pixels that show one piece of surface, or faces nearly in line, share their light.
[[nodiscard]] Raster shade(const PictureScene& scene, const SurfaceBuffer& buffer, const std::vector<float>& depth_mm,
                           const ColourScale& scale);

/// Returns a level of a colour for a value in [0, 255].
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

/// Returns the brightness of a surface, 0 to about 1; its unit normal has these components in the frame of a view.
[[nodiscard]] double light_on(double right, double up, double toward);

}  // namespace gouge
