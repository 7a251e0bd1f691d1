#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "lib/mesh/indexed_mesh.h"

namespace gouge {

/// The triangles with both ends of an edge.
struct EdgeTriangles {
  std::size_t count = 0;                 ///< 1 at a border, 2 where the surface is manifold
  std::array<std::uint32_t, 2> first{};  ///< the lowest of them
};

/// The triangles at each vertex: the least from which all that is adjacent can be stated.
class VertexTriangles {
 public:
  VertexTriangles() = default;
  /// Cost  O(n); 14 bytes a triangle, none beside while it is made.
  explicit VertexTriangles(const IndexedMesh& mesh);

  /// Returns the triangles in increasing order.
  [[nodiscard]] std::span<const std::uint32_t> at(Corner vertex) const {
    return {triangles_.data() + first_[vertex], first_[vertex + 1] - first_[vertex]};
  }
  /// Requires the mesh it was made of. Cost: as many steps as triangles meet at the end with fewer. Over all edges it
  /// is O(n) for a surface of few handles, however many triangles meet at a vertex.
  [[nodiscard]] EdgeTriangles at_edge(const IndexedMesh& mesh, Corner a, Corner b) const;

  /// Calls visit(a, b, edge) once for each edge, in the order of its first triangle. Requires and costs as at_edge.
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
  std::vector<std::uint32_t> first_;      // per vertex, and one more
  std::vector<std::uint32_t> triangles_;  // by vertex
};

}  // namespace gouge
