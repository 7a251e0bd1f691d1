#pragma once

#include <cstddef>

#include "lib/path/toolpath.h"
#include "lib/tilt/tilt_options.h"

namespace gouge {

/// Programmed positions whose tool axis is outside of a cone.
struct AxesOutside {
  std::size_t positions = 0;
  std::size_t first_move = kNone;  ///< the first move that ends at such a position; kNone: there is none
  double max_rad = 0;              ///< largest angle from the axis of the cone
};

/// Finds the moves whose axis at the end is more than a hundred-thousandth of a radian outside. Cost O(moves).
[[nodiscard]] AxesOutside find_axes_outside(const Toolpath& path, const AxisCone& cone);

}  // namespace gouge
