#pragma once

#include <algorithm>

#include "lib/tool/evaluate.h"

namespace gouge {

/// Returns whether the plane tangent to the tool at the foot of the point (r, z) bounds the depth of the points about
/// it. These are all points within `radius_mm` of it (SupportRange). The argument `here` is what evaluate states about
/// the point.
[[nodiscard]] inline bool is_bounded_by_tangent(const CompiledTool& tool, const ToolDistance& here, double r, double z,
                                                double radius_mm) {
  const SupportRange& support = tool.elements[here.element].support;
  if (here.normal.x() < 0) return false;
  return std::min(z, here.foot.y()) - radius_mm >= support.z_lo_mm &&
         std::max(z, here.foot.y()) + radius_mm <= support.z_hi_mm && r - radius_mm >= support.r_min_mm && r > 0;
}

}  // namespace gouge
