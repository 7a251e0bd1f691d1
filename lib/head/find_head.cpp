#include "lib/head/find_head.h"

#include <limits>

#include "lib/mesh/opposite_half_edges.h"

namespace gouge {
namespace {

bool is_in_solid(const Scene& scene, const Vec3& point) {
  for (const ObstacleMeshes& obstacle : obstacles_of(scene)) {
    for (const IndexedMesh& mesh : obstacle.meshes) {
      if (mesh.box().contains(point) && is_inside({&mesh, 1}, point)) return true;
    }
  }
  return false;
}

}  // namespace

std::size_t deepest_head(std::span<const HeadBody> heads, const Vec3& point_tool) {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t h = 0; h < heads.size(); ++h) {
    const double distance = heads[h].surface.closest_point(point_tool)->signed_mm();
    if (distance >= least) continue;
    least = distance;
    best = h;
  }
  return best;
}

std::optional<BuriedCore> find_buried_core(std::span<const HeadBody> heads, const RigidTransform& to_part,
                                           const Scene& scene) {
  for (std::size_t h = 0; h < heads.size(); ++h) {
    for (const Vec3& core : heads[h].cores) {
      const Vec3 at = to_part.point(core);
      if (is_in_solid(scene, at)) return BuriedCore{h, at};
    }
  }
  return std::nullopt;
}

}  // namespace gouge
