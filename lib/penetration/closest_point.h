#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "lib/penetration/depth_body.h"

namespace gouge {

/// The nearest point of a body's surface.
struct ClosestPoint {
  Vec3 point = Vec3::Zero();
  Vec3 normal =
      Vec3::UnitZ();           ///< unit; out of the body: along the line to or from the point, the facet's normal on it
  double distance_mm = 0;      ///< never negative
  bool is_inside = false;      ///< the point asked for lies in the solid
  std::uint32_t triangle = 0;  ///< of body.mesh
  std::uint32_t slot = 0;      ///< of the triangle in body.tree.order

  /// Negative inside.
  [[nodiscard]] double signed_mm() const { return is_inside ? -distance_mm : distance_mm; }
};

/// The closest point within `within_mm`; nothing when there is none (or no triangle at all).
///
/// Ensures  exact for any depth, both sides; of equally near facets one, always the same.
/// Requires for is_inside: body.is_solid. Of other bodies only the distance means something.
/// Cost     about O(log n); O(n) where only the winding number decides the side.
[[nodiscard]] std::optional<ClosestPoint> closest_point(const DepthBody& body, const Vec3& point,
                                                        double within_mm = std::numeric_limits<double>::infinity());

/// The same once facet `slot` of the tree is known to be nearest, with its foot.
[[nodiscard]] ClosestPoint signed_closest_point(const DepthBody& body, const Vec3& point, std::uint32_t slot,
                                                const TrianglePoint& foot);

}  // namespace gouge
