#pragma once

#include <cstdint>
#include <vector>

#include "lib/tool/compiled_tool.h"

namespace gouge {

/// One region of the Voronoi diagram on one side of the contour, as seen along the normals of its element: a
/// strip from the element (`near_points`) to where another element becomes the nearer one (`far_points`),
/// point by point.
struct TracedRegion {
  std::uint32_t element = 0;
  bool is_inside = false;
  std::vector<Vec2> near_points, far_points;
  std::vector<bool> is_bisector;  ///< per far point: ends at another region, not at the axis or the window
};

/// All regions within the window [0, high.x] x [low.y, high.y], traced through the BSP (not from its
/// equations), for pictures. Accuracy of the far points: 1e-9 of the tool's size along the normal.
[[nodiscard]] std::vector<TracedRegion> trace_regions(const CompiledTool& tool, const Vec2& low, const Vec2& high);

}  // namespace gouge
