#include "lib/clash/clash_body.h"

namespace gouge {

ClosestPoint ClashBody::closest_point(const Vec3& point) const {
  ClosestPoint foot = *surface_.closest_point(point);
  if (!is_self_crossing_ || !is_solid()) return foot;
  const bool is_in = surface_.winds_around(point);
  if (is_in != foot.is_inside) foot.normal = -foot.normal;
  foot.is_inside = is_in;
  return foot;
}

}  // namespace gouge
