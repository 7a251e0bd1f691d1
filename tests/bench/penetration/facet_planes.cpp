#include "tests/bench/penetration/facet_planes.h"

#include <algorithm>

namespace gouge {
namespace {

// The normal of a triangle this thin is wrong by a thousand roundings: 1e-13 of its size.
constexpr double kThinnest = 1e-3;

}  // namespace

FacetPlanes facet_planes(const std::array<Vec3, 3>& corners, const Vec3& normal) {
  FacetPlanes planes;
  double longest = 0;
  for (std::size_t k = 0; k < 3; ++k) longest = std::max(longest, (corners[(k + 1) % 3] - corners[k]).norm());
  const double height = (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm() / longest;
  if (!(height > kThinnest * longest)) return planes;
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec3& on = corners[k % 3];
    const Vec3 up = k == 3 ? normal : Vec3((corners[(k + 1) % 3] - on).cross(normal).normalized());
    const std::size_t slot = (k + 1) % 4;
    planes.x[slot] = up.x();
    planes.y[slot] = up.y();
    planes.z[slot] = up.z();
    planes.offset[slot] = up.dot(on);
  }
  return planes;
}

}  // namespace gouge
