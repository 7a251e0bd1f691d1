#include "lib/offset/vertex_offsets.h"

#include "lib/mesh/face_normal.h"

namespace gouge {
std::vector<Vec3> face_normals(const IndexedMesh& mesh) {
  std::vector<Vec3> normals(mesh.triangles.size(), Vec3::Zero());
  for (std::size_t t = 0; t < normals.size(); ++t) normals[t] = face_normal(mesh, t);
  return normals;
}

Vec3 angle_weighted_normal(const IndexedMesh& mesh, const MeshAdjacency& adjacency, const std::vector<Vec3>& normals,
                           Corner vertex) {
  Vec3 sum = Vec3::Zero();
  for (const std::uint32_t t : adjacency.triangles_of_vertex(vertex)) sum += angle_at(mesh, t, vertex) * normals[t];
  const double length = sum.norm();
  return length > 1e-12 ? Vec3(sum / length) : Vec3(Vec3::Zero());
}

std::vector<VertexOffset> offset_by_planes(const IndexedMesh& mesh, const MeshAdjacency& adjacency) {
  const std::vector<Vec3> normals = face_normals(mesh);
  std::vector<VertexOffset> all;
  all.reserve(mesh.vertices.size());
  std::vector<Vec3> faces;
  for (Corner v = 0; v < mesh.vertices.size(); ++v) {
    faces.clear();
    for (const std::uint32_t t : adjacency.triangles_of_vertex(v)) {
      if (normals[t].squaredNorm() > 0) faces.push_back(normals[t]);
    }
    const PlaneOffset offset = offset_of_planes(faces);
    all.push_back({offset.move, offset.planes});
  }
  return all;
}

}  // namespace gouge
