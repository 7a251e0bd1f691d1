#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "lib/geom/vec.h"

namespace gouge {

/// The side of a plane to which `direction` points: direction . x >= min_mm.
struct HalfSpace {
  Vec3 direction = Vec3::UnitZ();  ///< unit
  double min_mm = 0;
};

inline constexpr std::size_t kMaxHalfSpaces = 12;

/// Returns whether any point of a triangle is in all half-spaces, at most kMaxHalfSpaces of them. Points on a border
/// are in the half-space.
/// Source  I. Sutherland, G. Hodgman, Reentrant polygon clipping, Comm. ACM 17 (1974).
[[nodiscard]] inline bool is_any_within(const std::array<Vec3, 3>& triangle, std::span<const HalfSpace> space) {
  std::array<Vec3, 2 * (3 + kMaxHalfSpaces)> now, next;  // a cut adds one corner, or more after rounding
  std::copy(triangle.begin(), triangle.end(), now.begin());
  std::size_t count = triangle.size();
  for (const HalfSpace& half : space) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3 &a = now[i], &b = now[i + 1 < count ? i + 1 : 0];
      const double in_a = half.direction.dot(a) - half.min_mm, in_b = half.direction.dot(b) - half.min_mm;
      if (kept + 2 > next.size()) return true;  // too many corners; not proved to be outside
      if (in_a >= 0) next[kept++] = a;
      if ((in_a >= 0) != (in_b >= 0)) next[kept++] = a + in_a / (in_a - in_b) * (b - a);
    }
    if (kept == 0) return false;
    count = kept;
    std::swap(now, next);
  }
  return true;
}

}  // namespace gouge
