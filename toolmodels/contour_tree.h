#pragma once

#include <vector>

#include "lib/tool/compiled_tool.h"

namespace gouge {

/// A tree over a contour: stretches of it, each in a box and cut in halves, down to a few elements.
///
/// Requires  elements in contour order, arcs of at most 180 degrees.
/// Ensures   [0] holds all elements; every point of an element lies in the boxes of all stretches that hold it, rounding
///           apart; fewer stretches than elements. No stretches when there are no elements.
/// Cost      n log n
/// Source    own, docs/algorithms/tool_voronoi.md
[[nodiscard]] std::vector<ContourStretch> make_contour_tree(const std::vector<BoundaryElement>& elements);

/// The lines between the domains of neighbours (CompiledTool::borders). None for a contour that turns back on itself:
/// within a crack or a blade narrower than rounding two elements tie that know opposite sides, which no distance tells
/// apart.
[[nodiscard]] std::vector<DomainBorder> make_borders(const std::vector<BoundaryElement>& elements);

}  // namespace gouge
