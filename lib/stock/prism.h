#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "lib/geom/half_space.h"
#include "lib/geom/vec.h"

namespace gouge {

/// A piece of a facet of the part: a triangle in the plane of the facet.
struct FacetPiece {
  std::array<Vec3, 3> corners{};
  Vec3 normal = Vec3::UnitZ();  ///< unit, out of the part
  std::uint32_t mesh = 0;       ///< index of its mesh
  std::uint32_t triangle = 0;   ///< index of its facet in the mesh

  [[nodiscard]] Vec3 middle() const { return (corners[0] + corners[1] + corners[2]) / 3; }
  /// Returns the largest distance of a corner from the middle.
  [[nodiscard]] double radius_mm() const {
    const Vec3 m = middle();
    return std::sqrt(
        std::max({(corners[0] - m).squaredNorm(), (corners[1] - m).squaredNorm(), (corners[2] - m).squaredNorm()}));
  }
  [[nodiscard]] double area_mm2() const {
    return 0.5 * (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm();
  }
};

/// The points above a piece of a facet, between two heights along its normal.
struct Prism {
  const FacetPiece& base;
  double low_mm = 0, high_mm = 0;

  [[nodiscard]] Vec3 middle() const { return base.middle() + 0.5 * (low_mm + high_mm) * base.normal; }
  [[nodiscard]] std::array<Vec3, 6> corners() const {
    std::array<Vec3, 6> all;
    for (std::size_t k = 0; k < 3; ++k) {
      all[k] = base.corners[k] + low_mm * base.normal;
      all[k + 3] = base.corners[k] + high_mm * base.normal;
    }
    return all;
  }
  /// Returns its sides, each moved in by `inset_mm` (out where it is negative). Requires a piece with an area.
  [[nodiscard]] std::array<HalfSpace, 5> sides(double inset_mm) const {
    std::array<HalfSpace, 5> all;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& from = base.corners[k];
      const Vec3 inward = base.normal.cross(base.corners[(k + 1) % 3] - from).normalized();
      all[k] = {inward, inward.dot(from) + inset_mm};
    }
    const double at = base.normal.dot(base.corners[0]);
    all[3] = {base.normal, at + low_mm + inset_mm};
    all[4] = {-base.normal, -(at + high_mm) + inset_mm};
    return all;
  }
};

}  // namespace gouge
