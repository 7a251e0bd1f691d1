#pragma once

#include <vector>

#include "lib/tool/compiled_tool.h"

namespace gouge {

/// Maximum number of elements of a tool with a BSP. Cuts are straight lines or bisectors, and each runs through a whole
/// cell. So a traced contour, or one of many teeth, would be cut into far more cells than it has regions. Such a tool
/// has a tree over its contour instead (make_contour_tree).
inline constexpr std::size_t kMaxBspElements = 40;
inline constexpr std::size_t kMaxBspNodes = 16;

/// Builds the BSP over the Voronoi diagram of the elements' contour, inside and outside.
///
/// Requires  Elements in contour order, a vertex at every joint that is not smooth, arcs below 180 degrees.
/// Ensures   The leaf that a point reaches is its nearest element (except for rounding at ties), everywhere in r >= 0.
///           The root is nodes[0]. The result is empty in three cases: there is one element, there are more than
///           kMaxBspElements, or the diagram would need more than kMaxBspNodes nodes for each element.
/// Cost      Each node examines every line that still matters; milliseconds for twenty elements.
/// Source    Ho 1999, thesis 2.4.18; construction own, docs/method/tool_voronoi.md
[[nodiscard]] std::vector<BspNode> build_bsp(const std::vector<BoundaryElement>& elements);

/// Returns the largest number of nodes on a path from the root to a leaf.
[[nodiscard]] std::size_t bsp_depth(const std::vector<BspNode>& nodes);

}  // namespace gouge
