#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "lib/geom/point_triangle.h"
#include "lib/mesh/indexed_mesh.h"
#include "lib/mesh/vertex_triangles.h"

namespace gouge {

/// Decides on which side of a closed surface a point is, by the surface's closest point. It takes the normal of its
/// face, the mean of both faces at an edge, or the angle-weighted mean at a vertex. Normals are computed where they are
/// requested.
///
/// Source  J. A. Baerentzen, H. Aanaes, Signed distance computation using the angle weighted pseudonormal, IEEE Trans.
///         Vis. Comput. Graph. 11 (2005): exact for a closed orientable 2-manifold.
/// Deviates  Some features that the theorem does not cover have no normal: edges of other than two triangles,
///           neighbours without area, vertices whose normals cancel. There the winding number decides.
class SurfaceSign {
 public:
  SurfaceSign() = default;
  /// Mesh and triangles at its vertices must outlive it. Requires triangles with three distinct corners. Cost O(n).
  SurfaceSign(const IndexedMesh& mesh, const VertexTriangles& around);

  /// Returns the outward direction at a foot on `triangle`: zero where the winding number must be computed.
  /// Cost  As many steps as triangles meet at the foot, at most kMaxAround.
  [[nodiscard]] Vec3 outward(std::uint32_t triangle, TriangleFeature feature, std::size_t index) const;

 private:
  // Vertices of more triangles keep their normals: the tip of a cone is the nearest point of much of the space around.
  static constexpr std::size_t kMaxAround = 32;

  [[nodiscard]] Vec3 at_edge(Corner from, Corner to) const;
  [[nodiscard]] Vec3 at_vertex(Corner vertex) const;
  [[nodiscard]] bool is_plain(Corner vertex) const;

  const IndexedMesh* mesh_ = nullptr;
  const VertexTriangles* around_ = nullptr;
  std::vector<std::pair<Corner, Vec3>> kept_;  // by vertex
};

}  // namespace gouge
