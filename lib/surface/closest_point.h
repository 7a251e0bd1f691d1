#pragma once

#include <cstdint>

#include "lib/geom/vec.h"

namespace gouge {

/// The nearest point of a surface to a point.
struct ClosestPoint {
  Vec3 point = Vec3::Zero();
  Vec3 normal =
      Vec3::UnitZ();           ///< unit; out of the body: along the line to or from the point, the facet's normal on it
  double distance_mm = 0;      ///< never negative
  bool is_inside = false;      ///< the point asked for lies in the solid; never where the surface is none
  std::uint32_t triangle = 0;  ///< of the mesh

  /// Negative inside.
  [[nodiscard]] double signed_mm() const { return is_inside ? -distance_mm : distance_mm; }
};

}  // namespace gouge
