#pragma once

#include <cstdint>
#include <vector>

#include "lib/tool/compiled_tool.h"

namespace gouge {

/// One region of the Voronoi diagram on one side of the contour, as seen along the normals of its element. It is a
/// strip, point by point, from the element (`near_points`) to where another element becomes the nearer one
/// (`far_points`).
struct TracedRegion {
  std::uint32_t element = 0;
  bool is_inside = false;
  std::vector<Vec2> near_points, far_points;
  std::vector<bool> is_bisector;  ///< per far point: ends at another region, not at the axis or the window
};

/// Traces all regions within the window [0, high.x] x [low.y, high.y], through the BSP (not from its equations), for
/// pictures. Accuracy of the far points: 1e-9 of the tool's size along the normal.
[[nodiscard]] std::vector<TracedRegion> trace_regions(const CompiledTool& tool, const Vec2& low, const Vec2& high);

/// Builds a tree over a contour: stretches of it, each in a box and cut in halves, down to a few elements.
///
/// Requires  Elements in contour order, arcs of at most 180 degrees.
/// Ensures   Stretch [0] holds all elements. Every point of an element lies in the boxes of all stretches that hold it,
///           rounding apart. There are fewer stretches than elements. No stretches when there are no elements.
/// Cost      O(n log n).
/// Source    Own, docs/method/tool_voronoi.md
[[nodiscard]] std::vector<ContourStretch> make_contour_tree(const std::vector<BoundaryElement>& elements);

/// Returns the lines between the domains of neighbours (CompiledTool::borders). There are none for a contour that turns
/// back on itself. Within a crack or a blade narrower than rounding two elements tie that know opposite sides, and no
/// distance distinguishes them.
[[nodiscard]] std::vector<DomainBorder> make_borders(const std::vector<BoundaryElement>& elements);

}  // namespace gouge
