#pragma once

#include "lib/tool/compiled_tool.h"

namespace gouge {

/// Returns the largest radius of the solid strictly between two heights; negative if it has no point there.
[[nodiscard]] double widest_radius_mm(const CompiledTool& tool, double z_lo_mm, double z_hi_mm);

/// Bounds the radius of all points between two heights that are at least `depth_mm` inside the solid; negative if there
/// is none. Such a point is the centre of a ball inside the solid, so the solid is wider in every direction of the half
/// plane. Exact for cylinders. Proof: docs/method/stock.md, section "Pieces of the tool".
[[nodiscard]] double widest_radius_mm(const CompiledTool& tool, double z_lo_mm, double z_hi_mm, double depth_mm);

}  // namespace gouge
