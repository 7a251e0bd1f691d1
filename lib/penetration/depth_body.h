#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "lib/kdop/kdop_tree.h"
#include "lib/offset/vertex_offsets.h"
#include "lib/penetration/depth_grid.h"
#include "lib/surface/surface.h"

// The stationary body, as polygons: a k-DOP tree whose volumes include depth (thesis 4.6.2). So a point below the
// surface lies in the volume of the facet to which it is nearest.

namespace gouge {

enum class Coverage {
  offset,    ///< a leaf encloses its facets and their offset facets, as in thesis 4.6.2
  complete,  ///< and everything within the depth of a facet: no point within the depth is missed, on either side,
             ///< whatever the normals; the default
};

struct DepthBodyOptions {
  DirectionSet directions = cube_directions(26);
  double depth_mm = 1;  ///< D: depth of the volumes; deeper points are reported as "deeper than D"
  decltype(&offset_by_planes) offset_vertices = &offset_by_planes;  ///< computes the moves of vertices, which give the
                                                                    ///< depth of the volumes
  Coverage coverage = Coverage::complete;
  std::size_t width = 8;           ///< number of children of a node: 2, 4 or 8
  std::size_t leaf_triangles = 1;  ///< maximum number of triangles in a leaf
};

/// A facet for the filter of the narrow phase, in single precision: plane n . x = o, disc of radius r about c.
struct FacetRecord {
  float n[3], o, c[3], r;

  /// Returns a lower bound, up to the body's slack, of a point's distance from the facet's disc. It follows from the
  /// height of the point over the plane and its squared distance from the centre. The part across the plane is reduced
  /// by a millionth, because of the difference of squares in single precision.
  [[nodiscard]] static float min_distance(float height, float squared_distance, float radius) {
    const float across2 = squared_distance * (1 - 1e-6F) - height * height;
    const float beyond = across2 > radius * radius ? std::sqrt(across2) - radius : 0;
    return std::sqrt(height * height + beyond * beyond);
  }
};

struct DepthBody {
  Surface surface;
  DepthBodyOptions options;
  std::vector<VertexOffset> offsets;
  KdopTree tree;  ///< its items are triangles of mesh()
  /// Indexed by the slot in tree.order.
  std::vector<FacetRecord> facets;
  std::vector<std::array<Vec3, 3>> corners;
  /// Six numbers for each node: the box of its facets without depth, lower ends first. The box contains the facets in
  /// spite of rounding.
  std::vector<float> boxes;
  /// Indexed by slot. If set, nothing else of the surface crosses the prism of height depth_mm below the facet, so a
  /// point in the prism is inside.
  std::vector<std::uint8_t> is_clear_below;
  DepthGrid depths;    ///< finds points deeper than depth_mm; empty unless is_solid()
  float slack_mm = 0;  ///< maximum rounding of single precision

  [[nodiscard]] const IndexedMesh& mesh() const { return surface.mesh(); }
  [[nodiscard]] bool is_solid() const { return surface.is_solid(); }
};

/// Builds the body. Requires the guarantees of build_mesh, and depth_mm > 0.
/// Cost  O(n log^2 n); about 1.5 microseconds for each triangle.
[[nodiscard]] DepthBody build_depth_body(Surface surface, const DepthBodyOptions& options);

}  // namespace gouge
