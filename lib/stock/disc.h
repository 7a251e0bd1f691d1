#pragma once

#include <algorithm>
#include <cmath>

#include "lib/geom/vec.h"

namespace gouge {

/// A disc of the part's space; a point if its radius is 0. Pieces of tools are hulls of discs.
struct Disc {
  Vec3 center = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();  ///< unit
  double radius_mm = 0;

  /// Returns the smallest coordinate of the disc along a unit direction.
  [[nodiscard]] double lowest_mm(const Vec3& direction) const {
    if (!(radius_mm > 0)) return center.dot(direction);
    const double along = normal.dot(direction);
    return center.dot(direction) - radius_mm * std::sqrt(std::max(0.0, 1 - along * along));
  }
};

}  // namespace gouge
