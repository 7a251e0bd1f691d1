#pragma once

#include <array>
#include <cstdint>

#include "lib/geom/vec.h"

namespace gouge {

/// How a ray meets a triangle, whose front is the side from which its corners run anticlockwise.
enum class RayCrossing : std::uint8_t {
  none,     ///< beyond doubt
  out,      ///< through it to its front
  in,       ///< through it to its back
  doubtful  ///< through an edge or from its plane, as far as rounding tells
};

/// A triangle as the origin of rays sees it.
class RayCone {
 public:
  RayCone(const std::array<Vec3, 3>& triangle, const Vec3& origin);
  /// Requires a unit vector.
  [[nodiscard]] RayCrossing crossing(const Vec3& direction) const;

 private:
  std::array<Vec3, 3> corners_, sides_;
  std::array<double, 3> slack_{};
  double volume_ = 0, volume_slack_ = 0;
};

}  // namespace gouge
