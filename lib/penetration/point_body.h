#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lib/kdop/kdop_tree.h"
#include "lib/mesh/indexed_mesh.h"

// The body that moves, as points (thesis 4.2): a k-DOP tree about the body's own frame. A pose turns the
// corners of a node's volume and bounds them anew, which never costs what lies below (5.2.3, 6.1.4.2).

namespace gouge {

struct PointBodyOptions {
  DirectionSet directions = cube_directions(26);  ///< those of the other body
  std::size_t width = 2;
  std::size_t leaf_points = 20;  ///< at most
  /// Thesis 6.1.1: a volume must not cost more than its content. A node whose volume has more corners than points below
  /// gets none. The query then continues with its children; a leaf is bounded by its points.
  bool is_cost_weighed = true;
};

struct PointBody {
  PointBodyOptions options;
  KdopTree tree;             ///< items are points
  std::vector<Vec3> points;  ///< as given, in the body's frame, mm
  /// Corner coordinates in blocks of four x, four y, four z; the last block repeats the last corner.
  std::vector<float> corners;
  std::vector<std::uint32_t> corner_first;  ///< by node, in blocks; one more at the end
  std::vector<std::uint32_t> corner_count;  ///< by node; 0: the node has no volume
  /// Points in leaf order, as the corners are; every leaf begins a block.
  std::vector<float> leaf_points;
  std::vector<std::uint32_t> leaf_first;  ///< by node, in blocks; only of leaves
  double reach_mm = 0;                    ///< largest distance of a point from the frame's origin
};

/// Requires points; cost O(n log^2 n) and about 50 microseconds for every node with a volume (k = 26).
[[nodiscard]] PointBody build_point_body(std::span<const Vec3> points, const PointBodyOptions& options = {});

/// Returns points of a surface, such that no point of the surface is farther than `spacing_mm` from one of them.
///
/// The depth below another surface changes by no more than the distance moved. So the points of a moving body prove
/// bounds for all of its surface up to the spacing. Nothing deeper than the largest reported depth plus the spacing is
/// inside. Nothing that reaches deeper than the spacing is missed, between vertices, on an edge or amid a face that a
/// spike pierces.
///
/// Shape    The mesh's vertices first, in order; then the inner points of a grid over each triangle that is wide.
/// Requires spacing_mm > 0.
/// Cost     About area / spacing^2 points.
/// Source   Beyond thesis 4.2, which takes the vertices alone. A triangle is covered by its corners. None of its points
///          is farther from the nearest corner than the longest edge over the square root of 3.
[[nodiscard]] std::vector<Vec3> surface_points(const IndexedMesh& mesh, double spacing_mm);

}  // namespace gouge
