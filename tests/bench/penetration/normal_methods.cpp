#include "tests/bench/penetration/normal_methods.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/bench/penetration/paraboloid.h"

namespace gouge {
namespace {

class Offsetter {
 public:
  Offsetter(const IndexedMesh& mesh, const MeshAdjacency& adjacency)
      : mesh_(mesh), adjacency_(adjacency), normals_(face_normals(mesh)) {}

  [[nodiscard]] VertexOffset at(Corner vertex, bool is_paraboloid) {
    faces_.clear();
    for (const std::uint32_t t : adjacency_.triangles_of_vertex(vertex)) {
      if (normals_[t].squaredNorm() > 0) faces_.push_back(normals_[t]);
    }
    const VertexOffset planes = offset_of_planes(faces_);
    if (planes.planes == PlaneCase::none) return {};
    const Vec3 average = averaged(vertex, planes);
    if (!is_paraboloid) return {average, planes.planes};
    collect_neighbours(vertex);
    return {paraboloid_normal(mesh_.vertices[vertex], neighbours_, average), planes.planes};
  }

 private:
  [[nodiscard]] Vec3 averaged(Corner vertex, const VertexOffset& planes) const {
    const bool is_equiangular = planes.planes != PlaneCase::many_planes && planes.planes != PlaneCase::knife;
    if (is_equiangular) return planes.move.normalized();
    const Vec3 weighted = angle_weighted_normal(mesh_, adjacency_, normals_, vertex);
    return weighted.squaredNorm() > 0 ? weighted : faces_[0];
  }

  /// Ends of the edges at the vertex; with fewer than five, those of its neighbours as well.
  void collect_neighbours(Corner vertex) {
    corners_.clear();
    add_ring(vertex);
    tidy(vertex);
    if (corners_.size() < 5) {
      const std::vector<Corner> ring = corners_;
      for (const Corner c : ring) add_ring(c);
      tidy(vertex);
    }
    neighbours_.clear();
    for (const Corner c : corners_) neighbours_.push_back(mesh_.vertices[c]);
  }

  void add_ring(Corner vertex) {
    for (const std::uint32_t t : adjacency_.triangles_of_vertex(vertex)) {
      for (const Corner c : mesh_.triangles[t]) corners_.push_back(c);
    }
  }

  void tidy(Corner vertex) {
    std::sort(corners_.begin(), corners_.end());
    corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
    corners_.erase(std::remove(corners_.begin(), corners_.end(), vertex), corners_.end());
  }

  const IndexedMesh& mesh_;
  const MeshAdjacency& adjacency_;
  std::vector<Vec3> normals_;
  std::vector<Vec3> faces_, neighbours_;
  std::vector<Corner> corners_;
};

std::vector<VertexOffset> offset_vertices(const IndexedMesh& mesh, const MeshAdjacency& adjacency, bool is_paraboloid) {
  Offsetter offsetter(mesh, adjacency);
  std::vector<VertexOffset> all(mesh.vertices.size());
  for (Corner v = 0; v < all.size(); ++v) all[v] = offsetter.at(v, is_paraboloid);
  return all;
}

}  // namespace

std::vector<VertexOffset> offset_averaged(const IndexedMesh& mesh, const MeshAdjacency& adjacency) {
  return offset_vertices(mesh, adjacency, false);
}

std::vector<VertexOffset> offset_by_paraboloid(const IndexedMesh& mesh, const MeshAdjacency& adjacency) {
  return offset_vertices(mesh, adjacency, true);
}

double collapse_depth_mm(const IndexedMesh& mesh, const std::vector<VertexOffset>& offsets, std::size_t triangle) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const TriangleCorners& c = mesh.triangles[triangle];
  const Vec3 ab = mesh.vertices[c[1]] - mesh.vertices[c[0]], ac = mesh.vertices[c[2]] - mesh.vertices[c[0]];
  const Vec3 mb = offsets[c[1]].move - offsets[c[0]].move, mc = offsets[c[2]].move - offsets[c[0]].move;
  // n . ((ab - d mb) x (ac - d mc)) = s + q d + r d^2, with s the squared area vector
  const Vec3 n = ab.cross(ac);
  const double s = n.squaredNorm(), q = -n.dot(ab.cross(mc) + mb.cross(ac)), r = n.dot(mb.cross(mc));
  if (!(s > 0)) return kNever;
  const double root2 = q * q - 4 * r * s;
  if (root2 < 0) return kNever;
  // The roots are -2 s / (q -+ root); both forms stay finite for r = 0.
  const double root = std::sqrt(root2);
  double least = kNever;
  for (const double below : {q + root, q - root}) {
    if (below < 0) least = std::min(least, -2 * s / below);
  }
  return least;
}

}  // namespace gouge
