#pragma once

#include <array>
#include <vector>

#include "lib/penetration/depth_body.h"

namespace gouge {

/// How far from a solid at least everything in a block of space is, for blocks over its box.
class Clearance {
 public:
  /// Requires a solid.
  /// Cost     a search for each of at most 33^3 blocks.
  explicit Clearance(const DepthBody& body);

  /// Not above the distance of a point outside to the solid; 0 where the point may be inside.
  [[nodiscard]] double at(const Vec3& point) const;

 private:
  Vec3 low_, high_;
  double block_mm_ = 0;
  std::array<int, 3> counts_{0, 0, 0};
  std::vector<float> clear_;  ///< by block
};

}  // namespace gouge
