#pragma once

#include <span>

#include "lib/geom/vec.h"

namespace gouge {

/// A parallel projection of part coordinates onto pixels: x right, y down, z towards the viewer in mm.
struct View {
  Vec3 right = Vec3::UnitX(), up = Vec3::UnitY(), toward = Vec3::UnitZ();  ///< perpendicular unit vectors
  Vec3 centre = Vec3::Zero();                                              ///< point in the middle of the picture
  double mm_per_pixel = 1;
  int width = 1, height = 1;

  [[nodiscard]] Vec3 project(const Vec3& p) const {
    const Vec3 d = p - centre;
    return {0.5 * width + d.dot(right) / mm_per_pixel, 0.5 * height - d.dot(up) / mm_per_pixel, d.dot(toward)};
  }
  [[nodiscard]] Vec3 unproject(double x, double y, double z) const {
    return centre + right * ((x - 0.5 * width) * mm_per_pixel) + up * ((0.5 * height - y) * mm_per_pixel) + toward * z;
  }
};

/// Returns a view from the direction `toward` in which `up_hint` points up as far as possible. Requires `toward` not
/// zero.
[[nodiscard]] View make_view(const Vec3& toward, const Vec3& up_hint, int width, int height);

/// Moves and scales the view so that all points are visible, with a margin (`margin` is a fraction of the side).
void fit_view(View& view, std::span<const std::span<const Vec3>> points, double margin);

}  // namespace gouge
