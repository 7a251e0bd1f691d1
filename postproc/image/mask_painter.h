#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "lib/base/result.h"

// Drawing functions of OpenCV for pictures. They are in a separate shared module, which the first picture loads. OpenCV
// loads a dozen other libraries, which a check without pictures does not need.

namespace gouge {

/// Grey levels, rows from the top: how much of a colour is laid on each pixel.
struct Mask {
  int width = 0, height = 0;
  std::vector<std::uint8_t> grey;

  Mask(int w, int h) : width(w), height(h), grey(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
};

/// A point relative to the centre of the mask's left top pixel, in 1 / kMaskUnits of a pixel.
struct MaskPoint {
  int x = 0, y = 0;
};
inline constexpr int kMaskUnitBits = 4;
inline constexpr int kMaskUnits = 1 << kMaskUnitBits;

/// A painter of smoothed lines, areas and stroke letters in masks. The same calls give the same bytes, and calls from
/// several threads do not affect each other. Errors of all functions: out-of-memory, picture-not-encoded.
class MaskPainter {
 public:
  MaskPainter() = default;
  MaskPainter(const MaskPainter&) = delete;
  MaskPainter& operator=(const MaskPainter&) = delete;
  virtual ~MaskPainter() = default;

  /// Draws open lines through the points of each stroke, `thickness` pixels wide.
  virtual Outcome draw(Mask& mask, const std::vector<std::vector<MaskPoint>>& strokes, int thickness) const = 0;
  virtual Outcome fill(Mask& mask, const std::vector<MaskPoint>& outline) const = 0;

  /// Draws ASCII text in strokes; its base line begins at the pixel (x, y).
  virtual Outcome write(Mask& mask, const std::string& ascii, int x, int y, double scale, int thickness) const = 0;
  /// Returns the width in pixels; 0 if there is no memory to measure it.
  [[nodiscard]] virtual double width(const std::string& ascii, double scale) const = 0;

  /// Reduces a picture of three bytes a pixel by `factor` in each direction. Each new pixel is the mean of those that
  /// it covers.
  virtual Outcome shrink(const std::vector<std::uint8_t>& from, int width, int height, int factor,
                         std::vector<std::uint8_t>& to) const = 0;
};

/// Returns the painter of OpenCV, which the first call loads. Errors: module-missing, out-of-memory.
[[nodiscard]] Result<const MaskPainter*> mask_painter();

}  // namespace gouge
