#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lib/geom/point_triangle.h"
#include "lib/mesh/adjacency.h"
#include "lib/mesh/indexed_mesh.h"

namespace gouge {

/// On which side of a closed surface a point is, decided by the surface's closest point: by the normal of its
/// face, by the mean of both faces at an edge, by the angle-weighted mean at a vertex.
///
/// Source  J. A. Baerentzen, H. Aanaes, Signed distance computation using the angle weighted pseudonormal,
/// IEEE
///         Trans. Vis. Comput. Graph. 11 (2005): exact for a closed orientable 2-manifold.
/// Deviates  features the theorem does not cover (edges of other than two triangles, neighbours without area,
///         vertices whose normals cancel) have no normal; there the winding number decides.
class SurfaceSign {
 public:
  SurfaceSign() = default;
  SurfaceSign(const IndexedMesh& mesh, const MeshAdjacency& adjacency);

  /// Outward direction at a foot on `triangle`: zero where the winding number must be asked.
  [[nodiscard]] Vec3 outward(std::uint32_t triangle, TriangleFeature feature, std::size_t index) const;

  [[nodiscard]] const Vec3& face(std::uint32_t triangle) const { return faces_[triangle]; }

 private:
  std::vector<Vec3> faces_, edges_, vertices_;
  std::vector<std::array<std::uint32_t, 3>> triangle_edges_;
  std::vector<TriangleCorners> triangles_;
};

}  // namespace gouge
