#include "lib/clash/surface_query.h"

#include <algorithm>

#include "lib/geom/point_triangle.h"

namespace gouge::detail {

bool may_reach(const float* box, const BallCap& cap) {
  double out2 = 0, highest = 0;
  for (int i = 0; i < 3; ++i) {
    const double low = static_cast<double>(box[i]) - cap.centre[i];
    const double high = static_cast<double>(box[i + 3]) - cap.centre[i];
    const double out = std::max({low, -high, 0.0});
    out2 += out * out;
    highest += cap.direction[i] * (cap.direction[i] > 0 ? high : low);
  }
  return out2 <= cap.radius_mm * cap.radius_mm && highest >= cap.from_mm;
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
