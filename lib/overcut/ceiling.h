#pragma once

#include <cstdint>
#include <optional>

#include "lib/hierarchy/column_height.h"
#include "lib/surface/surface.h"

namespace gouge {

/// Finds a height, as that of a Column, above all of a closed surface within a cylinder. The cylinder extends
/// `reach_mm` to both sides of `column.through`. The height is at most `max_mm`. The space above it, up to max_mm and
/// reach_mm, is outside. So every point of the solid in the cylinder is below it. Returns nothing if no such height is
/// proved.
///
/// `column` has through, direction and radius; low and high are set here. The search does not look for a height below
/// `cutoff_mm`, which is at most `max_mm`. `is_through_outside` is true if column.through is known to be outside.
/// Triangle `near` is near the column.
/// Requires the boundary of a solid.
/// Proof    docs/method/overcut.md, section 4.
[[nodiscard]] std::optional<double> ceiling(const Surface& solid, Column column, double reach_mm, double cutoff_mm,
                                            double max_mm, bool is_through_outside = false, std::uint32_t near = 0);

}  // namespace gouge
