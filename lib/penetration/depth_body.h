#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "lib/kdop/kdop_tree.h"
#include "lib/offset/vertex_offsets.h"
#include "lib/penetration/depth_grid.h"
#include "lib/surface/surface.h"

// The body that stands still, as polygons: a k-DOP tree whose volumes carry depth (thesis 4.6.2). So a point below the
// surface lies in the volume of the facet it is nearest to.

namespace gouge {

enum class Coverage {
  offset,    ///< a leaf encloses its facets and their offset facets, as thesis 4.6.2 has it
  complete,  ///< and everything nearer to a facet than the depth: no point within the depth is missed, on
             ///< either side, whatever the normals; the default
};

struct DepthBodyOptions {
  DirectionSet directions = cube_directions(26);
  double depth_mm = 1;  ///< D: how deep the volumes reach; deeper is reported as "deeper than D"
  decltype(&offset_by_planes) offset_vertices = &offset_by_planes;  ///< where vertices go: the depth of the volumes
  Coverage coverage = Coverage::complete;
  std::size_t width = 8;           ///< children of a node: 2, 4 or 8
  std::size_t leaf_triangles = 1;  ///< at most
};

/// A facet as the narrow phase filters it, single precision: plane n . x = o, disc of radius r about c.
struct FacetRecord {
  float n[3], o, c[3], r;

  /// Returns a bound not above the distance of a point to the facet's disc, up to the body's slack. It follows from the
  /// point's height over the plane and its squared distance from the centre. The part across the plane is taken a
  /// millionth short, for the difference of squares in single precision.
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
  KdopTree tree;  ///< items are triangles of mesh()
  /// By slot in tree.order.
  std::vector<FacetRecord> facets;
  std::vector<std::array<Vec3, 3>> corners;
  /// Six numbers a node: the box of its facets without depth, lower ends first, not above the true ones.
  std::vector<float> boxes;
  /// By slot: nothing else of the surface crosses the prism of height depth_mm below the facet, so a point
  /// in it is inside.
  std::vector<std::uint8_t> is_clear_below;
  DepthGrid depths;    ///< knows what is deeper than depth_mm; empty unless is_solid()
  float slack_mm = 0;  ///< single precision may be off by this

  [[nodiscard]] const IndexedMesh& mesh() const { return surface.mesh(); }
  [[nodiscard]] bool is_solid() const { return surface.is_solid(); }
};

/// Requires what build_mesh ensures; depth_mm > 0.
/// Cost  O(n log^2 n); about 1.5 microseconds a triangle.
[[nodiscard]] DepthBody build_depth_body(Surface surface, const DepthBodyOptions& options);

}  // namespace gouge
