#include "lib/penetration/inner_reach.h"

#include <algorithm>
#include <cmath>

#include "lib/offset/vertex_offsets.h"

namespace gouge {
namespace {

// A ray this little outside a constraint still belongs to the cone: wider is safe.
constexpr double kFeasible = 1e-7;
constexpr double kNoPlane = 1e-13;
// The rays of so many constraints are not worth their time; all directions below the vertex hold them.
constexpr std::size_t kManyEdges = 40;

}  // namespace

InnerReach::InnerReach(const IndexedMesh& mesh, const MeshAdjacency& adjacency, const std::vector<Vec3>& face_normals)
    : mesh_(mesh), normals_(face_normals) {
  cones_.reserve(mesh.vertices.size());
  for (Corner v = 0; v < mesh.vertices.size(); ++v) cones_.push_back(cone_at(v, adjacency));
  find_wedges(adjacency);
}

/// A point is nearest to a vertex only if every edge there leads away from it: the cone of these constraints,
/// bounded by its extreme rays, which are crossings of two constraint planes.
InnerReach::Cone InnerReach::cone_at(Corner vertex, const MeshAdjacency& adjacency) const {
  const Vec3 outward = angle_weighted_normal(mesh_, adjacency, normals_, vertex);
  if (outward.squaredNorm() < 0.5) return {Vec3::UnitZ(), -1};
  std::vector<Vec3> constraints = {outward};
  for (const std::uint32_t t : adjacency.triangles_of_vertex(vertex)) {
    for (const Corner c : mesh_.triangles[t]) {
      const Vec3 edge = mesh_.vertices[c] - mesh_.vertices[vertex];
      const double length = edge.norm();
      if (c == vertex || !(length > 0)) continue;
      const Vec3 unit = edge / length;
      const bool is_known = std::any_of(constraints.begin(), constraints.end(),
                                        [&](const Vec3& k) { return (k - unit).cwiseAbs().maxCoeff() <= 0; });
      if (!is_known) constraints.push_back(unit);
    }
  }
  if (constraints.size() > kManyEdges) return {-outward, 0};
  Cone cone{-outward, 2};
  for (std::size_t i = 0; i < constraints.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Vec3 across = constraints[i].cross(constraints[j]);
      if (across.norm() < kNoPlane) continue;
      for (const double sign : {1.0, -1.0}) {
        const Vec3 ray = sign * across.normalized();
        const bool is_feasible =
            std::all_of(constraints.begin(), constraints.end(), [&](const Vec3& k) { return k.dot(ray) <= kFeasible; });
        if (is_feasible) cone.cosine = std::min(cone.cosine, cone.axis.dot(ray));
      }
    }
  }
  return cone;
}

void InnerReach::find_wedges(const MeshAdjacency& adjacency) {
  wedges_.resize(mesh_.triangles.size());
  for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      Cone& wedge = wedges_[t][k];
      const auto uses = adjacency.uses(adjacency.edges()[adjacency.edges_of_triangle(t)[k]]);
      const bool is_plain = uses.size() == 2 && uses[0].is_forward != uses[1].is_forward;
      const std::uint32_t other = is_plain ? (uses[0].triangle == t ? uses[1].triangle : uses[0].triangle) : t;
      const Vec3 sum = normals_[t] + normals_[other];
      const bool has_areas = normals_[t].squaredNorm() > 0 && normals_[other].squaredNorm() > 0;
      if (!is_plain || !has_areas || sum.norm() < 1e-6) {
        wedge = {Vec3::UnitZ(), -1};
        continue;
      }
      const Vec3 along = mesh_.corner(t, (k + 1) % 3) - mesh_.corner(t, k);
      const bool is_convex = normals_[t].cross(normals_[other]).dot(along) > 0;
      if (!is_convex) wedge = {-sum.normalized(), 0.5 * sum.norm()};
    }
  }
}

double InnerReach::above(std::uint32_t triangle, const Vec3& u, double depth_mm) const {
  const auto reach = [&](const Cone& cone) {
    if (cone.cosine > 1) return 0.0;
    const double cosine = u.dot(cone.axis);
    if (cosine >= cone.cosine) return 1.0;
    const double turn = std::sqrt(std::max(0.0, 1 - cone.cosine * cone.cosine));
    const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    return std::max(0.0, cosine * cone.cosine + sine * turn);
  };
  const std::array<Vec3, 3> facet = {mesh_.corner(triangle, 0), mesh_.corner(triangle, 1), mesh_.corner(triangle, 2)};
  std::array<double, 3> at{};
  for (std::size_t k = 0; k < 3; ++k) at[k] = u.dot(facet[k]);
  const double below = normals_[triangle].squaredNorm() > 0 ? std::max(0.0, -u.dot(normals_[triangle])) : 1.0;
  double most = *std::max_element(at.begin(), at.end()) + depth_mm * below;
  for (std::size_t k = 0; k < 3; ++k) {
    most = std::max(most, at[k] + depth_mm * reach(cones_[mesh_.triangles[triangle][k]]));
    most = std::max(most, std::max(at[k], at[(k + 1) % 3]) + depth_mm * reach(wedges_[triangle][k]));
  }
  return most;
}

}  // namespace gouge
