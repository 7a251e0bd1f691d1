#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "lib/mesh/indexed_mesh.h"

namespace gouge {

/// The triangles that contain both ends of an edge.
struct EdgeTriangles {
  std::size_t count = 0;                 ///< 1 at a border, 2 where the surface is manifold
  std::array<std::uint32_t, 2> first{};  ///< the two lowest of them
};

/// The triangles at each vertex: the smallest structure that gives all adjacency.
class VertexTriangles {
 public:
  VertexTriangles() = default;
  /// Builds the lists. Cost  O(n); 14 bytes for each triangle, and no further memory during the build.
  explicit VertexTriangles(const IndexedMesh& mesh);

  /// Returns the triangles of a vertex in increasing order.
  [[nodiscard]] std::span<const std::uint32_t> at(Corner vertex) const {
    return {triangles_.data() + first_[vertex], first_[vertex + 1] - first_[vertex]};
  }
  /// Returns the triangles at an edge. Requires the mesh from which the lists were made. Cost: the number of triangles
  /// at the end with fewer. Over all edges the sum is O(n) for a surface with few handles, however many triangles meet
  /// at a vertex.
  [[nodiscard]] EdgeTriangles at_edge(const IndexedMesh& mesh, Corner a, Corner b) const;

  /// Calls visit(a, b, edge) once for each edge, in the order of its first triangle. The requirement and the cost are
  /// those of at_edge.
  template <typename Visit>
  void for_each_edge(const IndexedMesh& mesh, const Visit& visit) const {
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Corner a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
        const EdgeTriangles edge = at_edge(mesh, a, b);
        if (edge.first[0] == t) visit(a, b, edge);
      }
    }
  }

 private:
  std::vector<std::uint32_t> first_;      // for each vertex, plus one more entry
  std::vector<std::uint32_t> triangles_;  // ordered by vertex
};

}  // namespace gouge
