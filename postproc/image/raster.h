#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "lib/base/large_pages.h"

// Pixels as plain data.

namespace gouge {

/// Factor by which every picture is painted larger in each direction, before it is averaged down.
inline constexpr int kSupersampling = 2;

/// The pixels of a picture in rows from the top; three bytes (red, green, blue) for each pixel.
struct Raster {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;

  Raster() = default;
  Raster(int w, int h, std::uint8_t r, std::uint8_t g, std::uint8_t b) : width(w), height(h) {
    const std::size_t bytes = static_cast<std::size_t>(w) * static_cast<std::size_t>(h) * 3;
    reserve_large(rgb, bytes);
    rgb.resize(bytes, r);
    if (r == g && g == b) return;
    for (std::size_t i = 0; i < rgb.size(); i += 3) {
      rgb[i] = r;
      rgb[i + 1] = g;
      rgb[i + 2] = b;
    }
  }
  [[nodiscard]] std::uint8_t* pixel(int x, int y) {
    return rgb.data() +
           (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) * 3;
  }
};

/// A raster with kSupersampling times the size that it has in the picture. Its left top corner is at (x, y) in the
/// picture.
struct PlacedRaster {
  int x = 0, y = 0;
  Raster raster;
};

}  // namespace gouge
