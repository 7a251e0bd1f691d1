#pragma once

#include <algorithm>
#include <cmath>

#include "lib/geom/vec.h"

namespace gouge {

/// Calls `at(point)` along a line between two projected points, in steps of at most a pixel (longer for lines of more
/// than 20,000 pixels).
template <class At>
void walk_line(const Vec3& a, const Vec3& b, At&& at) {
  constexpr double kMaxSteps = 20'000;
  const double pixels = std::max(std::abs(b.x() - a.x()), std::abs(b.y() - a.y()));
  const int steps = static_cast<int>(std::min(std::ceil(pixels), kMaxSteps)) + 1;
  for (int s = 0; s <= steps; ++s) at(Vec3(a + (b - a) * (static_cast<double>(s) / steps)));
}

/// Calls `put(point, x, y)` for the pixels of such a line within the picture, two of them side by side, perpendicular
/// to its main direction.
template <class Put>
void walk_two_wide(const Vec3& a, const Vec3& b, int width, int height, Put&& put) {
  const bool is_steep = std::abs(b.x() - a.x()) < std::abs(b.y() - a.y());
  walk_line(a, b, [&](const Vec3& p) {
    for (int k = 0; k < 2; ++k) {
      const int x = static_cast<int>(std::floor(p.x())) + (is_steep ? k : 0);
      const int y = static_cast<int>(std::floor(p.y())) + (is_steep ? 0 : k);
      if (x >= 0 && y >= 0 && x < width && y < height) put(p, x, y);
    }
  });
}

}  // namespace gouge
