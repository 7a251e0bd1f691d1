#include "lib/penetration/surface_points.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gouge {

std::vector<Vec3> surface_points(const IndexedMesh& mesh, double spacing_mm) {
  std::vector<Vec3> points = mesh.vertices;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vec3 &a = mesh.corner(t, 0), &b = mesh.corner(t, 1), &c = mesh.corner(t, 2);
    const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    const auto parts = static_cast<std::size_t>(std::ceil(longest / (std::numbers::sqrt3 * spacing_mm)));
    const double step = 1.0 / static_cast<double>(std::max<std::size_t>(parts, 1));
    for (std::size_t i = 0; i <= parts; ++i) {
      for (std::size_t j = 0; i + j <= parts; ++j) {
        const bool is_corner = i == parts || j == parts || (i == 0 && j == 0);
        if (is_corner) continue;
        points.emplace_back(a + static_cast<double>(i) * step * (b - a) + static_cast<double>(j) * step * (c - a));
      }
    }
  }
  return points;
}

}  // namespace gouge
