#pragma once

#include <cstdint>
#include <optional>

#include "lib/hierarchy/column_height.h"
#include "lib/surface/surface.h"

namespace gouge {

/// A height, as of a Column's, over all of a closed surface within a cylinder that `reach_mm` to both sides of
/// `column.through` holds; at most `max_mm`, and what is above it, up to there and to reach_mm, is outside. So every
/// point of the solid in the cylinder is below it. Nothing where no such height is proven.
///
/// `column`: through, direction and radius; low and high are set here. `cutoff_mm`: no lower height is requested, at
/// most `max_mm`. `is_through_outside`: known to be. `near`: a triangle near the column.
/// Requires a solid's boundary.
/// Proof    docs/method/overcut.md, section 4.
[[nodiscard]] std::optional<double> ceiling(const Surface& solid, Column column, double reach_mm, double cutoff_mm,
                                            double max_mm, bool is_through_outside = false, std::uint32_t near = 0);

}  // namespace gouge
