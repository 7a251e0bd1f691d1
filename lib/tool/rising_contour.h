#pragma once

#include <optional>
#include <vector>

#include "lib/tool/compiled_tool.h"

namespace gouge {

/// Returns the contour of a solid that holds the tool and whose contour never goes down: hollows of the underside and
/// overhangs are filled from the height of their lowest point, pits of the top up to their rim. Vertices are left out.
/// Returns nothing where some fill is higher than `max_fill_mm`, or the contour rises out of a pit of the top.
///
/// Requires  Segments and arcs in contour order; arcs of less than half a circle.
/// Proof     The contour encloses the tool, since each fill is bounded by a level line and by the contour itself.
[[nodiscard]] std::optional<std::vector<BoundaryElement>> fill_overhangs(const std::vector<BoundaryElement>& elements,
                                                                         double max_fill_mm);

}  // namespace gouge
