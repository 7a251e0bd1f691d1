#pragma once

#include <cstdint>
#include <vector>

#include "lib/tool/compiled_tool.h"
#include "toolmodels/profile.h"

namespace gouge {

/// One region of the Voronoi diagram on one side of the contour, traced along the normals of its element. It is a
/// strip: each normal runs from a point on the element (`near_points`) to the point where another element becomes
/// nearer (`far_points`).
struct TracedRegion {
  std::uint32_t element = 0;
  bool is_inside = false;
  std::vector<Vec2> near_points, far_points;
  /// for each far point, whether it lies on the border to another region, not on the axis or the window
  std::vector<bool> is_bisector;
};

/// Traces all regions within the window [0, high.x] x [low.y, high.y], for pictures. It uses the BSP, not its
/// equations. Accuracy of the far points: 1e-9 of the tool's size along the normal.
[[nodiscard]] std::vector<TracedRegion> trace_regions(const CompiledTool& tool, const Vec2& low, const Vec2& high);

/// Builds a tree over a contour. Its nodes are stretches of the contour, each with a box; they are halved down to a few
/// elements.
///
/// Requires  Elements in contour order, arcs of at most 180 degrees.
/// Ensures   Stretch [0] holds all elements. Every point of an element lies in the boxes of all stretches that hold it,
///           up to rounding. There are fewer stretches than elements, and none if there are no elements.
/// Cost      O(n log n).
/// Source    Own, docs/method/tool_voronoi.md
[[nodiscard]] std::vector<ContourStretch> make_contour_tree(const std::vector<BoundaryElement>& elements);

/// Returns the lines between the domains of neighbours (CompiledTool::borders). There are none for a contour that turns
/// back on itself. In a crack or a blade narrower than rounding, two elements with opposite sides have the same
/// distance. So no distance can distinguish them.
[[nodiscard]] std::vector<DomainBorder> make_borders(const std::vector<BoundaryElement>& elements);

/// Returns the elements of a contour, and its borders and tree where they are more than kMaxBspElements. It has no BSP:
/// its distances (evaluate_by_stretches) are looked up only a few times for each element.
[[nodiscard]] CompiledTool make_contour_solid(const Profile& profile);

}  // namespace gouge
