#pragma once

#include <vector>

#include "lib/tool/compiled_tool.h"

namespace gouge {

/// Limits the elements of a tool with a BSP. Cuts are straight or bisectors and go through all of a cell. So a contour
/// of many teeth or a traced one is cut into far more cells than it has regions. Such a tool has a tree over its
/// contour (make_contour_tree).
inline constexpr std::size_t kMaxBspElements = 40;
inline constexpr std::size_t kMaxBspNodes = 16;

/// Builds the BSP over the Voronoi diagram of the elements' contour, inside and outside.
///
/// Requires  Elements in contour order, a vertex at every joint that is not smooth, arcs below 180 degrees.
/// Ensures   The leaf that a point reaches is its nearest element (rounding at ties apart), everywhere in r >= 0. The
///           root is nodes[0]. There are no nodes in three cases: one element, more than kMaxBspElements, or a diagram
///           of more than kMaxBspNodes nodes for each element.
/// Cost      Each node examines every line that still matters; milliseconds for twenty elements.
/// Source    Ho 1999, thesis 2.4.18; construction own, docs/method/tool_voronoi.md
[[nodiscard]] std::vector<BspNode> build_bsp(const std::vector<BoundaryElement>& elements);

/// Returns the largest number of nodes on a path from the root to a leaf.
[[nodiscard]] std::size_t bsp_depth(const std::vector<BspNode>& nodes);

}  // namespace gouge
