#pragma once

#include <algorithm>

#include "lib/tool/evaluate.h"

namespace gouge {

/// Returns whether a tangent plane of the tool bounds the depth of the points around the point (r, z). The plane is the
/// one at the closest point of the tool. The bound is for all points within `radius_mm` (SupportRange). `here` is the
/// result of evaluate for the point.
[[nodiscard]] inline bool is_bounded_by_tangent(const CompiledTool& tool, const ToolDistance& here, double r, double z,
                                                double radius_mm) {
  const SupportRange& support = tool.elements[here.element].support;
  if (here.normal.x() < 0) return false;
  return std::min(z, here.foot.y()) - radius_mm >= support.z_lo_mm &&
         std::max(z, here.foot.y()) + radius_mm <= support.z_hi_mm && r - radius_mm >= support.r_min_mm && r > 0;
}

}  // namespace gouge
