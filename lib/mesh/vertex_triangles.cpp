#include "lib/mesh/vertex_triangles.h"

#include <numeric>

namespace gouge {

VertexTriangles::VertexTriangles(const IndexedMesh& mesh) : first_(mesh.vertices.size() + 1, 0) {
  for (const TriangleCorners& corners : mesh.triangles) {
    for (const Corner c : corners) ++first_[c];
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  triangles_.resize(3 * mesh.triangles.size());
  // From the back, each list's end runs down to its beginning.
  for (auto t = static_cast<std::uint32_t>(mesh.triangles.size()); t-- > 0;) {
    for (const Corner c : mesh.triangles[t]) triangles_[--first_[c]] = t;
  }
}

}  // namespace gouge
