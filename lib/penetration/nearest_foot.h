#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "lib/penetration/depth_body.h"

namespace gouge {

/// The nearest point of a body's surface.
struct SurfaceFoot {
  Vec3 point = Vec3::Zero();
  Vec3 normal =
      Vec3::UnitZ();  ///< unit; out of the body: along the way from or to the foot, the facet's normal on it
  double distance_mm = 0;      ///< never negative
  bool is_inside = false;      ///< the point asked for lies in the solid
  std::uint32_t triangle = 0;  ///< of body.mesh
  std::uint32_t place = 0;     ///< of the triangle in body.tree.order

  /// Negative inside.
  [[nodiscard]] double signed_mm() const { return is_inside ? -distance_mm : distance_mm; }
};

/// The nearest foot within `within_mm`; nothing when there is none (or no triangle at all).
///
/// Ensures  exact for any depth, both sides; of equally near facets one, always the same.
/// Requires for is_inside: body.is_solid. Of other bodies only the distance means something.
/// Cost     about O(log n); O(n) where only the winding number can tell the side.
[[nodiscard]] std::optional<SurfaceFoot> nearest_foot(
    const DepthBody& body, const Vec3& point, double within_mm = std::numeric_limits<double>::infinity());

/// The same once facet `place` of the tree is known to be nearest, with its foot.
[[nodiscard]] SurfaceFoot signed_foot(const DepthBody& body, const Vec3& point, std::uint32_t place,
                                      const TriangleFoot& foot);

}  // namespace gouge
