#include "lib/clash/surface_query.h"

#include <algorithm>

#include "lib/base/tolerance.h"
#include "lib/geom/point_triangle.h"

namespace gouge::detail {
namespace {}  // namespace

bool may_reach(const LaneBound& bound, const BallCap& cap) {
  const double highest = cap.direction.dot(bound.center - cap.centre) + bound.extent_mm(cap.direction);
  return highest >= cap.from_mm - Tolerance::kRounding_mm &&
         bound.min_distance_mm(cap.centre) <= cap.radius_mm + Tolerance::kRounding_mm;
}

std::optional<Vec3> nearest_in_cap(const std::array<Vec3, 3>& facet, const BallCap& cap) {
  const auto height = [&](const Vec3& x) { return cap.direction.dot(x - cap.centre) - cap.from_mm; };
  std::array<Vec3, 4> kept;
  std::size_t count = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 &a = facet[k], &b = facet[(k + 1) % 3];
    const double at_a = height(a), at_b = height(b);
    if (at_a >= 0) kept[count++] = a;
    if ((at_a >= 0) != (at_b >= 0)) kept[count++] = a + at_a / (at_a - at_b) * (b - a);
  }
  if (count == 0) return std::nullopt;
  TrianglePoint best = closest_on_triangle(
      cap.centre, {kept[0], kept[std::min<std::size_t>(1, count - 1)], kept[std::min<std::size_t>(2, count - 1)]});
  if (count == 4) {
    const TrianglePoint other = closest_on_triangle(cap.centre, {kept[0], kept[2], kept[3]});
    if (other.distance2_mm2 < best.distance2_mm2) best = other;
  }
  if (best.distance2_mm2 > cap.radius_mm * cap.radius_mm) return std::nullopt;
  return best.point;
}

}  // namespace gouge::detail
