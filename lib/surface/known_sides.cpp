#include "lib/surface/known_sides.h"

#include <algorithm>

namespace gouge {
namespace {

constexpr double kOnSurface_mm = 1e-9;  // nearer, a point has no side to speak of

}  // namespace

ClosestPoint KnownSides::closest_point(const Vec3& point) {
  return on_true_side(point, *surface_.closest_point(point));
}

ClosestPoint KnownSides::closest_point_from(const Vec3& point, std::uint32_t near) {
  return on_true_side(point, surface_.closest_point_from(point, near));
}

ClosestPoint KnownSides::on_true_side(const Vec3& point, ClosestPoint foot) {
  if (!surface_.is_solid() || foot.distance_mm <= kOnSurface_mm) return foot;
  Ball ball{point, foot.distance_mm, false};
  ball.is_inside = find_side(ball);
  balls_[count_++ % balls_.size()] = ball;
  if (ball.is_inside != foot.is_inside) foot.normal = -foot.normal;
  foot.is_inside = ball.is_inside;
  return foot;
}

bool KnownSides::find_side(const Ball& ball) const {
  const std::size_t known = std::min(count_, balls_.size());
  for (std::size_t k = 0; k < known; ++k) {
    const double reach = (1 - 1e-9) * (ball.radius_mm + balls_[k].radius_mm) - kOnSurface_mm;
    if (reach > 0 && (ball.centre - balls_[k].centre).squaredNorm() < reach * reach) return balls_[k].is_inside;
  }
  return surface_.winds_around(ball.centre);
}

}  // namespace gouge
