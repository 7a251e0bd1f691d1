#include "lib/mesh/free_ray.h"

#include <cstddef>

#include "lib/mesh/ray_cone.h"

namespace gouge {

bool has_free_ray(const IndexedMesh& mesh, std::span<const Vec3> origins, std::span<const Vec3> directions) {
  std::vector<std::vector<Vec3>> open(origins.size());
  for (std::vector<Vec3>& own : open) {
    for (const Vec3& d : directions) own.push_back(d.normalized());
  }
  std::size_t left = origins.size() * directions.size();
  for (std::size_t t = 0; t < mesh.triangles.size() && left > 0; ++t) {
    for (std::size_t o = 0; o < origins.size(); ++o) {
      if (open[o].empty()) continue;
      const RayCone cone({mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)}, origins[o]);
      left -= std::erase_if(open[o], [&](const Vec3& d) { return cone.crossing(d) != RayCrossing::none; });
    }
  }
  return left > 0;
}

}  // namespace gouge
