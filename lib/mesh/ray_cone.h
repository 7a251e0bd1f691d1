#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "lib/geom/vec.h"
#include "lib/mesh/indexed_mesh.h"

namespace gouge {

/// Ways in which a ray meets a triangle. The front of a triangle is the side from which its corners run anticlockwise.
enum class RayCrossing : std::uint8_t {
  none,     ///< the ray certainly misses it
  out,      ///< the ray goes through it to its front
  in,       ///< the ray goes through it to its back
  doubtful  ///< up to rounding the ray goes through an edge or starts in its plane
};

/// A triangle in the view from the origin of rays.
class RayCone {
 public:
  RayCone(const std::array<Vec3, 3>& triangle, const Vec3& origin);
  /// Returns how a ray from the origin meets the triangle. Requires a unit vector.
  [[nodiscard]] RayCrossing crossing(const Vec3& direction) const;

 private:
  std::array<Vec3, 3> corners_, sides_;
  std::array<double, 3> slack_{};
  double volume_ = 0, volume_slack_ = 0;
};

/// Returns whether a ray from one of `origins` in one of `directions` certainly meets no triangle. A ray that could be
/// a hit because of rounding counts as a hit.
///
/// Ensures  If true, a straight line off the surface joins one of the origins with infinity.
/// Requires directions that are not zero.
/// Cost     O(n) times the number of rays that are not yet known to be blocked; if all are blocked, few remain after
///          the first triangles.
[[nodiscard]] bool has_free_ray(const IndexedMesh& mesh, std::span<const Vec3> origins,
                                std::span<const Vec3> directions);

}  // namespace gouge
