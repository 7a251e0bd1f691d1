#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "lib/geom/vec.h"
#include "lib/mesh/indexed_mesh.h"

namespace gouge {

/// Ways in which a ray meets a triangle. Its front is the side from which its corners run anticlockwise.
enum class RayCrossing : std::uint8_t {
  none,     ///< beyond doubt
  out,      ///< through it to its front
  in,       ///< through it to its back
  doubtful  ///< through an edge or from its plane, up to rounding
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

/// Returns whether from one of `origins` a ray in one of `directions` meets no triangle, beyond doubt. A ray that
/// rounding could turn into a hit counts as one.
///
/// Ensures  On true, one of the origins is joined with infinity by a straight line that keeps off the surface.
/// Requires directions that are not zero.
/// Cost     O(n) times the rays not yet known to be blocked; few remain after the first triangles where all are.
[[nodiscard]] bool has_free_ray(const IndexedMesh& mesh, std::span<const Vec3> origins,
                                std::span<const Vec3> directions);

}  // namespace gouge
