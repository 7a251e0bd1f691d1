#pragma once

#include <cstddef>
#include <vector>

#include "lib/path/toolpath.h"

namespace gouge {

/// For each move of a corrected path, the programmed unit axis at its end, as find_axis_tilts (axis_tilt.h) says.
/// Requires one origin for each move of `after`.
[[nodiscard]] std::vector<Vec3> programmed_axes(const Toolpath& before, const Toolpath& after,
                                                const std::vector<std::size_t>& origins);

}  // namespace gouge
