#include "lib/tilt/axes_outside.h"

#include <algorithm>

#include "lib/base/tolerance.h"
#include "lib/path/path_info.h"

namespace gouge {

AxesOutside find_axes_outside(const Toolpath& path, const AxisCone& cone) {
  AxesOutside outside;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const double angle = angle_between_rad(path.moves[i].end.axis, cone.axis);
    if (angle <= cone.half_angle_rad + Tolerance::kFileAxis) continue;
    if (outside.positions++ == 0) outside.first_move = i;
    outside.max_rad = std::max(outside.max_rad, angle);
  }
  return outside;
}

}  // namespace gouge
