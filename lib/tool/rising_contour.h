#pragma once

#include <optional>
#include <vector>

#include "lib/tool/compiled_tool.h"

namespace gouge {

/// Returns the contour of a solid that holds the tool and whose contour never goes down: hollows of the underside and
/// overhangs are filled from the height of their lowest point, pits of the top up to their rim. Vertices are left out.
/// Returns nothing if a fill is higher than `max_fill_mm`, if the contour rises out of a pit of the top, or if a part
/// beneath an overhang is wider than the overhang.
///
/// Requires  Segments and arcs in contour order; arcs of less than half a circle.
/// Proof     A fill replaces a part of the contour by a level line at its lowest point. No removed part is wider than the
///           outer end of that line. The contour crosses itself nowhere, so it goes on outside of all removed parts.
[[nodiscard]] std::optional<std::vector<BoundaryElement>> fill_overhangs(const std::vector<BoundaryElement>& elements,
                                                                         double max_fill_mm);

}  // namespace gouge
