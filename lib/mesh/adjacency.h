#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "lib/mesh/indexed_mesh.h"
#include "lib/mesh/vertex_triangles.h"

// Lists the triangles that meet at an edge and at a vertex (thesis 4.2, 4.5.2.3). Any mesh has an adjacency: an edge
// may belong to one triangle or to many, in either direction.

namespace gouge {

/// The use of an edge by one triangle.
struct EdgeUse {
  std::uint32_t triangle = 0;
  bool is_forward = true;  ///< the triangle's side runs from the edge's lower vertex index to the higher one
};

struct MeshEdge {
  Corner low = 0;  ///< low < high
  Corner high = 0;
  std::uint32_t first_use = 0;  ///< index into the uses of MeshAdjacency
  std::uint32_t use_count = 0;  ///< 1: boundary; 2: manifold; more: non-manifold
};

class MeshAdjacency {
 public:
  /// Builds the adjacency. Cost O(n). Requires triangles with three distinct corners, as build_mesh returns them.
  explicit MeshAdjacency(const IndexedMesh& mesh);

  /// Returns the edges in increasing order of (low, high).
  [[nodiscard]] const std::vector<MeshEdge>& edges() const { return edges_; }

  /// Returns the uses in increasing order of triangle.
  [[nodiscard]] std::span<const EdgeUse> uses(const MeshEdge& edge) const {
    return {uses_.data() + edge.first_use, edge.use_count};
  }

  /// Returns the edges of a triangle. Edge k runs from corner k to corner k + 1 (mod 3).
  [[nodiscard]] const std::array<std::uint32_t, 3>& edges_of_triangle(std::size_t triangle) const {
    return triangle_edges_[triangle];
  }

  /// Returns the triangles of a vertex in increasing order.
  [[nodiscard]] std::span<const std::uint32_t> triangles_of_vertex(Corner vertex) const { return around_.at(vertex); }

 private:
  VertexTriangles around_;
  std::vector<MeshEdge> edges_;
  std::vector<EdgeUse> uses_;
  std::vector<std::array<std::uint32_t, 3>> triangle_edges_;
};

}  // namespace gouge
