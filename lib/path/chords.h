#pragma once

#include <vector>

#include "lib/path/toolpath.h"

namespace gouge {

/// Positions along the move `index` on an arc or a spline, its end included, so that straight moves from its start
/// through them stay within `error_mm` of it. The axis turns evenly on the great circle. Requires a curve and
/// a start. Cost: at most about 10000 positions for a piece or a turn.
[[nodiscard]] std::vector<Pose> chords_of(const Toolpath& path, std::size_t index, double error_mm);

}  // namespace gouge
