#pragma once

#include <cstddef>

#include "lib/path/toolpath.h"
#include "lib/tilt/tilt_options.h"

namespace gouge {

/// Programmed positions whose tool axis lies outside a cone.
struct AxesOutside {
  std::size_t positions = 0;
  std::size_t first_move = kNone;  ///< ends at the first of them; kNone: there is none
  double max_rad = 0;              ///< from the axis of the cone, the farthest
};

/// Finds the moves of which the axis at the end is more than a hundred-thousandth of a radian outside. Cost O(moves).
[[nodiscard]] AxesOutside find_axes_outside(const Toolpath& path, const AxisCone& cone);

}  // namespace gouge
