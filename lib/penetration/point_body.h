#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lib/kdop/kdop_tree.h"
#include "lib/mesh/indexed_mesh.h"

// The moving body, as points (thesis 4.2): a k-DOP tree in the body's own frame. A pose turns the corners of a node's
// volume and bounds them anew. The cost does not depend on the content below the node (5.2.3, 6.1.4.2).

namespace gouge {

struct PointBodyOptions {
  DirectionSet directions = cube_directions(26);  ///< the same directions as those of the other body
  std::size_t width = 2;
  std::size_t leaf_points = 20;  ///< maximum number of points in a leaf
  /// Thesis 6.1.1: a volume must not cost more than its content. If its volume has more corners than the node has
  /// points, the node gets no volume. The query then continues with its children; a leaf is bounded by its points.
  bool is_cost_weighed = true;
};

struct PointBody {
  PointBodyOptions options;
  KdopTree tree;             ///< its items are points
  std::vector<Vec3> points;  ///< as passed in, in the body's frame, mm
  /// Corner coordinates in blocks of four x, four y, four z. The last block repeats the last corner.
  std::vector<float> corners;
  std::vector<std::uint32_t> corner_first;  ///< by node, in blocks; with one more entry at the end
  std::vector<std::uint32_t> corner_count;  ///< by node; 0: the node has no volume
  /// Points in leaf order, in the same blocks as the corners. Every leaf begins a block.
  std::vector<float> leaf_points;
  std::vector<std::uint32_t> leaf_first;  ///< by node, in blocks; valid only for leaves
  double reach_mm = 0;                    ///< largest distance of a point from the frame's origin
};

/// Builds the body. Requires points. Cost: O(n log^2 n), and about 50 microseconds for every node with a volume (k =
/// 26).
[[nodiscard]] PointBody build_point_body(std::span<const Vec3> points, const PointBodyOptions& options = {});

/// Returns points of a surface. No point of the surface is farther than `spacing_mm` from one of them.
///
/// The depth below another surface changes by at most the distance moved. So the points of a moving body prove bounds
/// for its whole surface, up to the spacing. No inside point is deeper than the largest reported depth plus the
/// spacing. No place that reaches deeper than the spacing is missed: between vertices, on an edge, or inside a face
/// that a spike pierces.
///
/// Shape    First the mesh's vertices, in order; then the inner points of a grid over each wide triangle.
/// Requires spacing_mm > 0.
/// Cost     About area / spacing^2 points.
/// Source   Extends thesis 4.2, which uses only the vertices. A triangle is covered by its corners: no point is farther
///          from the nearest corner than the longest edge over the square root of 3.
[[nodiscard]] std::vector<Vec3> surface_points(const IndexedMesh& mesh, double spacing_mm);

}  // namespace gouge
