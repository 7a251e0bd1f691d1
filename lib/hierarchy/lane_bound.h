#pragma once

#include <array>
#include <cstddef>

#include "lib/hierarchy/block_tree.h"

namespace gouge {

/// One child of a node in double precision and part coordinates. Everything below it lies within `radius_mm` of the
/// center, and in a cylinder about the axis through it along `normal`. Its bounds are wide enough for the length of the
/// stored normal. They are off by at most 1e-9 mm of rounding for coordinates up to 100 m.
struct LaneBound {
  Vec3 center = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();  ///< unit to 3e-7
  double half_thickness_mm = 0, disc_radius_mm = 0, radius_mm = 0;

  LaneBound(const BlockTree& tree, const NodeBlock& node, std::size_t lane);
  /// The bound of a whole tree.
  explicit LaneBound(const BlockTree& tree);

  /// Returns a bound of direction . (x - center) for all its points x. Requires a unit vector.
  [[nodiscard]] double extent_mm(const Vec3& direction) const;
  /// Returns a distance from `point` that no point of it undercuts.
  [[nodiscard]] double min_distance_mm(const Vec3& point) const;
  /// Returns the corners of a box around the cylinder, upright on its disc. The cylinder is within their convex hull.
  [[nodiscard]] std::array<Vec3, 8> hull() const;
};

}  // namespace gouge
