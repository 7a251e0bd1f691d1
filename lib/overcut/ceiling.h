#pragma once

#include <cstdint>
#include <optional>

#include "lib/hierarchy/column_height.h"
#include "lib/surface/surface.h"

namespace gouge {

/// Finds a height, as of a Column's, over all of a closed surface within a cylinder. The cylinder extends `reach_mm` to
/// both sides of `column.through`. The height is at most `max_mm`. The space above it, up to there and to reach_mm, is
/// outside. So every point of the solid in the cylinder is below it. Returns nothing where no such height is proved.
///
/// The `column` states through, direction and radius; low and high are set here. No height lower than `cutoff_mm`, at
/// most `max_mm`, is requested. The flag `is_through_outside` is true where that is known. The triangle `near` is near
/// the column.
/// Requires a solid's boundary.
/// Proof    docs/method/overcut.md, section 4.
[[nodiscard]] std::optional<double> ceiling(const Surface& solid, Column column, double reach_mm, double cutoff_mm,
                                            double max_mm, bool is_through_outside = false, std::uint32_t near = 0);

}  // namespace gouge
