#include "lib/clash/local_maximum.h"

#include <utility>

#include "lib/base/tolerance.h"
#include "lib/clash/surface_query.h"

namespace gouge {
namespace {

// Minimum cosine between a direction and the inward normals of facets at which the direction leads away from a facet.
// The same holds for an edge between two such facets ...
constexpr double kMinCosine = 0.02;
// ... and from a vertex whose facets all are within 45 degrees of it.
constexpr double kVertexCosine = 0.7072;
constexpr int kTries = 10;

}  // namespace

LocalMaxima::LocalMaxima(Surface surface)
    : surface_(std::move(surface)),
      is_reflex_(surface_.mesh().vertices.size(), false),
      is_loose_(surface_.mesh().triangles.size(), false) {
  const IndexedMesh& mesh = surface_.mesh();
  const auto is_convex = [&](const EdgeTriangles& edge) {
    if (edge.count != 2) return false;
    const Vec3 own = face_normal(mesh, edge.first[0]), other = face_normal(mesh, edge.first[1]);
    if (!(own.squaredNorm() > 0 && other.squaredNorm() > 0)) return false;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 across = mesh.corner(edge.first[1], k) - mesh.corner(edge.first[0], 0);
      if (own.dot(across) > Tolerance::kSameDirection * across.norm()) return false;
    }
    return true;
  };
  surface_.triangles_at_vertices().for_each_edge(mesh, [&](Corner a, Corner b, const EdgeTriangles& edge) {
    if (!is_convex(edge)) is_reflex_[a] = is_reflex_[b] = true;
    if (edge.count == 1) is_loose_[edge.first[0]] = true;
  });
}

bool LocalMaxima::may_hold(const Vec3& centre, double radius, const ClosestPoint& foot) const {
  const double reach = foot.distance_mm + 2 * radius;
  Vec3 sum = -foot.normal;
  for (int i = 0; i < kTries; ++i) {
    if (!(sum.norm() > kMinCosine)) return true;
    const Vec3 direction = sum.normalized();
    const auto hit = find_in_cap(surface_, {centre, reach, direction, -radius}, [&](std::uint32_t triangle) {
      return leads_away(triangle, direction, centre, reach);
    });
    if (!hit) return false;
    sum -= surface_.face_normal(hit->triangle);
  }
  return true;
}

bool LocalMaxima::leads_away(std::uint32_t triangle, const Vec3& direction, const Vec3& centre, double reach) const {
  const double cosine = -surface_.face_normal(triangle).dot(direction);
  if (cosine >= kVertexCosine) return true;
  if (!(cosine >= kMinCosine) || is_loose_[triangle]) return false;
  for (const Corner corner : surface_.mesh().triangles[triangle]) {
    const bool is_within = (surface_.mesh().vertices[corner] - centre).squaredNorm() <= reach * reach;
    if (is_within && is_reflex_[corner]) return false;
  }
  return true;
}

}  // namespace gouge
