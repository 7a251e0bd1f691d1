#pragma once

#include <array>
#include <cstring>

#include "lib/geom/vec.h"

namespace gouge {

/// A facet's plane and the three planes that stand on it along its edges, unit normals outward, side by side:
/// where a point is over the facet, its height is the distance; elsewhere they bound it from below.
struct alignas(64) FacetPlanes {
  std::array<double, 4> x{}, y{}, z{}, offset{};  ///< the facet's own first

  /// Heights of a point over the four planes.
  struct Heights {
    double over_mm;    ///< above the facet's plane; negative below
    double beyond_mm;  ///< the farthest beyond an edge; negative when the point is over the facet
  };
  [[nodiscard]] Heights at(const Vec3& p) const {
    const Two own = heights(p, 0), rest = heights(p, 2);
    const double two = own[1] > rest[0] ? own[1] : rest[0];
    return {own[0], two > rest[1] ? two : rest[1]};
  }

  [[nodiscard]] Vec3 normal() const { return {x[0], y[0], z[0]}; }

 private:
  using Two = double __attribute__((vector_size(16)));

  [[nodiscard]] static Two load(const double* from) {
    Two v;
    std::memcpy(&v, from, sizeof v);
    return v;
  }
  [[nodiscard]] Two heights(const Vec3& p, std::size_t k) const {
    return load(x.data() + k) * p.x() + load(y.data() + k) * p.y() + load(z.data() + k) * p.z() -
           load(offset.data() + k);
  }
};

/// All zero, so that nothing follows from them, for facets too thin for their normals to be trusted.
[[nodiscard]] FacetPlanes facet_planes(const std::array<Vec3, 3>& corners, const Vec3& normal);

}  // namespace gouge
