#pragma once

#include "lib/verify/tool_contour.h"

// Radii of a tool between two heights. Both functions require RoundsUpward and are linear in the pieces of the contour.

namespace gouge {

/// Returns a radius for which the cylinder about the axis between two heights is in the tool; negative: there is none.
[[nodiscard]] double free_radius_mm(const ToolContour& tool, double low, double high);

/// Returns an upper bound of the radii of the tool's points between two heights; negative: it has none there.
[[nodiscard]] double widest_radius_mm(const ToolContour& tool, double low, double high);

}  // namespace gouge
