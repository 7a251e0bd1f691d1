#pragma once

#include <cstddef>
#include <vector>

#include "lib/path/axis_tilt.h"

namespace gouge {

/// The run of the moves [first, last) of a corrected path with its curve: these moves, and up to a tenth of their
/// length (1 to 10 mm) of the feed moves on each side. `programmed` has the programmed axis at the end of every move.
/// All but tilt_rad, which is left as it is.
[[nodiscard]] TiltedRun draw_tilt_curve(const Toolpath& after, const std::vector<Vec3>& programmed, std::size_t first,
                                        std::size_t last);

}  // namespace gouge
