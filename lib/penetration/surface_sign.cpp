#include "lib/penetration/surface_sign.h"

#include "lib/offset/vertex_offsets.h"

namespace gouge {

SurfaceSign::SurfaceSign(const IndexedMesh& mesh, const MeshAdjacency& adjacency)
    : faces_(face_normals(mesh)), triangles_(mesh.triangles) {
  edges_.resize(adjacency.edges().size(), Vec3::Zero());
  vertices_.resize(mesh.vertices.size(), Vec3::Zero());
  std::vector<bool> is_doubtful(mesh.vertices.size(), false);
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const MeshEdge& edge = adjacency.edges()[e];
    const auto uses = adjacency.uses(edge);
    bool is_plain = uses.size() == 2 && uses[0].is_forward != uses[1].is_forward;
    for (const EdgeUse& use : uses) {
      is_plain = is_plain && faces_[use.triangle].squaredNorm() > 0;
      edges_[e] += faces_[use.triangle];
    }
    if (is_plain) continue;
    edges_[e].setZero();
    is_doubtful[edge.low] = is_doubtful[edge.high] = true;
  }
  for (Corner v = 0; v < vertices_.size(); ++v) {
    if (!is_doubtful[v]) vertices_[v] = angle_weighted_normal(mesh, adjacency, faces_, v);
  }
  triangle_edges_.reserve(triangles_.size());
  for (std::size_t t = 0; t < triangles_.size(); ++t) triangle_edges_.push_back(adjacency.edges_of_triangle(t));
}

Vec3 SurfaceSign::outward(std::uint32_t triangle, TriangleFeature feature, std::size_t index) const {
  if (feature == TriangleFeature::face) return faces_[triangle];
  if (feature == TriangleFeature::edge) return edges_[triangle_edges_[triangle][index]];
  return vertices_[triangles_[triangle][index]];
}

}  // namespace gouge
