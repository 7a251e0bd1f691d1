#pragma once

#include <array>
#include <cstddef>

#include "lib/surface/surface.h"

namespace gouge {

/// Closest points of a solid with the true side, also where its surface crosses itself or shells lie in one another: the
/// nearest triangle does not show it there. The ball about a point up to the surface is all on one side, and so are two
/// that meet; only a point whose ball meets none of the last ones costs a ray. For one thread.
class KnownSides {
 public:
  /// The surface must outlive it.
  explicit KnownSides(const Surface& surface) : surface_(surface) {}

  [[nodiscard]] const Surface& surface() const { return surface_; }
  /// Requires a surface with triangles.
  [[nodiscard]] ClosestPoint closest_point(const Vec3& point);
  /// As Surface::closest_point_from.
  [[nodiscard]] ClosestPoint closest_point_from(const Vec3& point, std::uint32_t near);
  /// `foot`: what Surface says of the point.
  [[nodiscard]] ClosestPoint on_true_side(const Vec3& point, ClosestPoint foot);

 private:
  struct Ball {
    Vec3 centre = Vec3::Zero();
    double radius_mm = 0;
    bool is_inside = false;
  };

  [[nodiscard]] bool find_side(const Ball& ball) const;

  const Surface& surface_;
  std::array<Ball, 24> balls_;  // the last ones
  std::size_t count_ = 0;
};

}  // namespace gouge
