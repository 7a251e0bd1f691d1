#include "lib/mesh/vertex_triangles.h"

#include <algorithm>
#include <numeric>

namespace gouge {

VertexTriangles::VertexTriangles(const IndexedMesh& mesh) : first_(mesh.vertices.size() + 1, 0) {
  for (const TriangleCorners& corners : mesh.triangles) {
    for (const Corner c : corners) ++first_[c];
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  triangles_.resize(3 * mesh.triangles.size());
  // Fills each list from its end to its beginning, with the triangles in reverse order.
  for (auto t = static_cast<std::uint32_t>(mesh.triangles.size()); t-- > 0;) {
    for (const Corner c : mesh.triangles[t]) triangles_[--first_[c]] = t;
  }
}

EdgeTriangles VertexTriangles::at_edge(const IndexedMesh& mesh, Corner a, Corner b) const {
  const bool is_fewer = at(a).size() <= at(b).size();
  EdgeTriangles edge;
  for (const std::uint32_t t : at(is_fewer ? a : b)) {
    const TriangleCorners& corners = mesh.triangles[t];
    if (std::find(corners.begin(), corners.end(), is_fewer ? b : a) == corners.end()) continue;
    if (edge.count < edge.first.size()) edge.first[edge.count] = t;
    ++edge.count;
  }
  return edge;
}

}  // namespace gouge
