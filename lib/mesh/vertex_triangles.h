#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lib/mesh/indexed_mesh.h"

namespace gouge {

/// The triangles at each vertex: the least from which all that is adjacent can be told.
class VertexTriangles {
 public:
  VertexTriangles() = default;
  /// Cost  O(n); 14 bytes a triangle, none beside while it is made.
  explicit VertexTriangles(const IndexedMesh& mesh);

  /// In increasing order.
  [[nodiscard]] std::span<const std::uint32_t> at(Corner vertex) const {
    return {triangles_.data() + first_[vertex], first_[vertex + 1] - first_[vertex]};
  }

 private:
  std::vector<std::uint32_t> first_;      // per vertex, and one more
  std::vector<std::uint32_t> triangles_;  // by vertex
};

}  // namespace gouge
