#include "postproc/viewer/viewer_mesh.h"

#include <limits>
#include <unordered_map>

namespace gouge {
namespace {

constexpr std::uint32_t kNoVertex = std::numeric_limits<std::uint32_t>::max();
constexpr std::size_t kMostEdges = 300'000;
constexpr float kSameNormal = 0.9999F;
constexpr std::size_t kMoreVertices = 200'000;  // along sharp edges, and where the surface is cut finer

}  // namespace

ViewerMesh ViewerMesh::from(const PictureScene& scene) {
  const std::uint32_t faces = scene.face_count();
  ViewerMesh out;
  out.triangles.reserve(faces);
  const std::size_t vertices = scene.vertex_count() + kMoreVertices;
  out.positions.reserve(vertices);
  out.normals.reserve(vertices);
  out.mesh_of.reserve(vertices);
  // By vertex of the scene the last copy made of it, and by copy the one before.
  std::vector<std::uint32_t> latest(scene.vertex_count(), kNoVertex), before;
  before.reserve(scene.vertex_count());
  for (std::uint32_t f = 0; f < faces; ++f) {
    const std::array<std::uint32_t, 3> corners = scene.corner_vertices(f);
    const std::array<Eigen::Vector3f, 3>& normals = scene.normals(f);
    std::array<std::uint32_t, 3> triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t copy = latest[corners[k]];
      while (copy != kNoVertex && out.normals[copy].dot(normals[k]) < kSameNormal) copy = before[copy];
      if (copy == kNoVertex) {
        copy = static_cast<std::uint32_t>(out.positions.size());
        out.positions.push_back(scene.vertex(corners[k]));
        out.normals.push_back(normals[k]);
        out.mesh_of.push_back(scene.mesh_of(f));
        before.push_back(latest[corners[k]]);
        latest[corners[k]] = copy;
      }
      triangle[k] = copy;
    }
    out.triangles.push_back(triangle);
  }
  if (scene.edges().size() <= kMostEdges) {
    for (const PictureScene::Edge& edge : scene.edges()) {
      if (latest[edge.a] != kNoVertex && latest[edge.b] != kNoVertex)
        out.edges.push_back({latest[edge.a], latest[edge.b]});
    }
  }
  return out;
}

}  // namespace gouge
