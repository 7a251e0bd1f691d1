#include "lib/surface/surface.h"

#include <cmath>
#include <mutex>
#include <utility>

#include "lib/hierarchy/closest_triangle.h"
#include "lib/mesh/mesh_findings.h"
#include "lib/mesh/winding.h"
#include "lib/surface/surface_sign.h"

namespace gouge {

struct Surface::Shared {
  IndexedMesh own_mesh;
  BlockTree own_tree;
  const IndexedMesh* mesh = nullptr;
  const BlockTree* tree = nullptr;
  struct Sides {
    bool is_solid = false;
    SurfaceSign sign;  ///< of a solid
  };
  mutable std::once_flag are_sides_made;
  mutable Sides made_sides;

  [[nodiscard]] const Sides& sides() const {
    std::call_once(are_sides_made, [this] {
      made_sides.is_solid = find_mesh_findings(*mesh).is_solid();
      if (made_sides.is_solid) made_sides.sign = SurfaceSign(*mesh);
    });
    return made_sides;
  }
};

Surface::Surface(const IndexedMesh& mesh, unsigned threads) {
  const auto shared = std::make_shared<Shared>();
  shared->mesh = &mesh;
  shared->own_tree = build_block_tree({&mesh, 1}, threads);
  shared->tree = &shared->own_tree;
  shared_ = shared;
}

Surface::Surface(IndexedMesh&& mesh) {
  const auto shared = std::make_shared<Shared>();
  shared->own_mesh = std::move(mesh);
  shared->mesh = &shared->own_mesh;
  shared->own_tree = build_block_tree({&shared->own_mesh, 1});
  shared->tree = &shared->own_tree;
  shared_ = shared;
}

Surface::Surface(const IndexedMesh& mesh, const BlockTree& tree) {
  const auto shared = std::make_shared<Shared>();
  shared->mesh = &mesh;
  shared->tree = &tree;
  shared_ = shared;
}

const IndexedMesh& Surface::mesh() const { return *shared_->mesh; }

const BlockTree& Surface::tree() const { return *shared_->tree; }

bool Surface::is_solid() const { return shared_->sides().is_solid; }

std::optional<ClosestPoint> Surface::closest_point(const Vec3& point, double within_mm) const {
  const auto found = closest_triangle(tree(), point, within_mm);
  if (!found) return std::nullopt;
  return signed_closest_point(point, found->triangle, found->foot);
}

ClosestPoint Surface::signed_closest_point(const Vec3& point, std::uint32_t triangle, const TrianglePoint& foot) const {
  ClosestPoint result;
  result.point = foot.point;
  result.triangle = triangle;
  result.distance_mm = std::sqrt(foot.distance2_mm2);
  const Vec3 displacement = point - foot.point;
  if (const Shared::Sides& sides = shared_->sides(); sides.is_solid) {
    const Vec3 outward = sides.sign.outward(triangle, foot.feature, foot.index);
    const double side = displacement.dot(outward);
    result.is_inside = outward.squaredNorm() > 0 ? side < 0 : is_inside({&mesh(), 1}, point);
  }
  result.normal = face_normal(triangle);
  if (result.distance_mm > 0) result.normal = (result.is_inside ? -1.0 : 1.0) / result.distance_mm * displacement;
  return result;
}

}  // namespace gouge
