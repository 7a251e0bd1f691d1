#pragma once

#include <cstdint>
#include <vector>

#include "lib/surface/surface.h"

namespace gouge {

/// Places where the distance from inside a solid to its surface may have a local maximum.
class LocalMaxima {
 public:
  /// Requires a solid's boundary. Cost O(n).
  explicit LocalMaxima(Surface surface);

  /// Returns false when it is proved that no point of the solid within `radius_mm` of `centre` is a local maximum. The
  /// proof is a direction that leads away from all points of the surface that may be nearest to any of them. The foot
  /// is that of the centre.
  [[nodiscard]] bool may_hold(const Vec3& centre, double radius_mm, const ClosestPoint& foot) const;

 private:
  [[nodiscard]] bool leads_away(std::uint32_t triangle, const Vec3& direction, const Vec3& centre,
                                double reach_mm) const;

  Surface surface_;
  std::vector<bool> is_reflex_;  // by vertex: on an edge with material on more than half of the way around it
  std::vector<bool> is_loose_;   // by triangle: with an edge that is a cut through triangles
};

}  // namespace gouge
