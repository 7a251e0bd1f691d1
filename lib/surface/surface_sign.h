#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "lib/geom/point_triangle.h"
#include "lib/mesh/indexed_mesh.h"
#include "lib/mesh/vertex_triangles.h"

namespace gouge {

/// The side of a closed surface on which a point lies, determined at the surface's closest point. The normal of the
/// face decides; at an edge the mean normal of both faces, at a vertex the angle-weighted mean. Normals are computed
/// when they are requested.
///
/// Source  J. A. Baerentzen, H. Aanaes, Signed distance computation using the angle weighted pseudonormal, IEEE Trans.
///         Vis. Comput. Graph. 11 (2005): exact for a closed orientable 2-manifold.
/// Deviates  Some features that the theorem does not cover have no normal. These are edges without exactly two
///           triangles, neighbours without area, and vertices whose normals cancel. For them the winding number
///           decides.
class SurfaceSign {
 public:
  SurfaceSign() = default;
  /// Prepares the normals. The mesh and the triangles at its vertices must outlive the object. Requires triangles with
  /// three distinct corners. Cost O(n).
  SurfaceSign(const IndexedMesh& mesh, const VertexTriangles& around);

  /// Returns the outward direction at a foot on `triangle`; zero if the winding number must be computed.
  /// Cost  The number of triangles that meet at the foot, at most kMaxAround.
  [[nodiscard]] Vec3 outward(std::uint32_t triangle, TriangleFeature feature, std::size_t index) const;

 private:
  // Normals of vertices with more triangles are stored: the tip of a cone is the nearest point of much of the space
  // around it.
  static constexpr std::size_t kMaxAround = 32;

  [[nodiscard]] Vec3 at_edge(Corner from, Corner to) const;
  [[nodiscard]] Vec3 at_vertex(Corner vertex) const;
  [[nodiscard]] bool is_plain(Corner vertex) const;

  const IndexedMesh* mesh_ = nullptr;
  const VertexTriangles* around_ = nullptr;
  std::vector<std::pair<Corner, Vec3>> kept_;  // in the order of vertices
};

}  // namespace gouge
