#include "lib/clash/setup_overlaps.h"

#include <utility>

namespace gouge {
namespace {

std::vector<Box3> boxes_of(std::span<const IndexedMesh> meshes) {
  std::vector<Box3> boxes;
  for (const IndexedMesh& mesh : meshes) boxes.push_back(mesh.box());
  return boxes;
}

/// Two bodies whose boxes have a slab of at most that thickness in common are nowhere deeper in each other: along the
/// slab's normal each point of it is that near to the end of either body.
bool may_be_deeper(const Box3& a, const Box3& b, double tolerance_mm) {
  return a.intersects(b) && a.intersection(b).sizes().minCoeff() > tolerance_mm;
}

void add_overlaps(const PreparedObstacle& workpiece, const PreparedObstacle& other,
                  const std::vector<bool>& is_left_out, const ClashOptions& options, std::vector<SetupOverlap>& found) {
  const std::vector<Box3> parts = boxes_of(workpiece.meshes), others = boxes_of(other.meshes);
  for (std::size_t f = 0; f < others.size(); ++f) {
    for (std::size_t p = 0; p < parts.size(); ++p) {
      if (is_left_out[f] || !may_be_deeper(parts[p], others[f], options.tolerance_mm)) continue;
      Clash clash = find_clash(ClashBody(workpiece.surfaces[p]), ClashBody(other.surfaces[f]), Vec3::Zero(), options);
      if (clash.state != ClashState::free && clash.state != ClashState::touching)
        found.push_back({f, p, std::move(clash)});
    }
  }
}

}  // namespace

std::vector<SetupOverlap> find_setup_overlaps(const PreparedScene& scene, const std::vector<bool>& is_left_out,
                                              const ClashOptions& options) {
  std::vector<SetupOverlap> found;
  for (const PreparedObstacle& obstacle : scene.obstacles()) {
    if (!obstacle.rule.is_workpiece) add_overlaps(scene.workpiece(), obstacle, is_left_out, options, found);
  }
  return found;
}

}  // namespace gouge
