#include "lib/clash/clash_body.h"

#include <cmath>

#include "lib/mesh/winding.h"

namespace gouge {

SurfaceFoot ClashBody::closest_point(const Vec3& point) const {
  SurfaceFoot foot = *nearest_foot(surface_, point);
  if (!is_self_crossing_ || !is_solid()) return foot;
  const bool is_inside = std::abs(winding_number(surface_.mesh, point)) > 0.5;
  if (is_inside != foot.is_inside) foot.normal = -foot.normal;
  foot.is_inside = is_inside;
  return foot;
}

}  // namespace gouge
