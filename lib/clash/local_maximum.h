#pragma once

#include <cstdint>
#include <vector>

#include "lib/surface/surface.h"

namespace gouge {

/// Finder of places where the distance from inside a solid to its surface may have a local maximum.
class LocalMaxima {
 public:
  /// Prepares the finder. Requires the boundary of a solid. Cost O(n).
  explicit LocalMaxima(Surface surface);

  /// Returns false if it is proved that no point of the solid within `radius_mm` of `centre` is a local maximum. The
  /// proof is a direction that leads away from all surface points that may be nearest to any of these points. `foot` is
  /// the closest surface point of the centre.
  [[nodiscard]] bool may_hold(const Vec3& centre, double radius_mm, const ClosestPoint& foot) const;

 private:
  [[nodiscard]] bool leads_away(std::uint32_t triangle, const Vec3& direction, const Vec3& centre,
                                double reach_mm) const;

  Surface surface_;
  std::vector<bool> is_reflex_;  // for each vertex: it lies on an edge with material on more than half of the way
                                 // around
  std::vector<bool> is_loose_;   // for each triangle: it has an edge that is a cut through triangles
};

}  // namespace gouge
