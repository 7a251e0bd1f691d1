#pragma once

#include <array>
#include <cstddef>

#include "lib/hierarchy/block_tree.h"

namespace gouge {

/// One child of a node, in double precision and part coordinates. Everything below it is within `radius_mm` of the
/// center, and in a cylinder along `normal` through the center. Its bounds allow for the length of the stored normal.
/// Their rounding is at most 1e-9 mm for coordinates up to 100 m.
struct LaneBound {
  Vec3 center = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();  ///< unit, accurate to 3e-7
  double half_thickness_mm = 0, disc_radius_mm = 0, radius_mm = 0;

  LaneBound(const BlockTree& tree, const NodeBlock& node, std::size_t lane);
  /// Builds the bound of a whole tree.
  explicit LaneBound(const BlockTree& tree);

  /// Returns an upper bound of direction . (x - center) for all its points x. Requires a unit vector.
  [[nodiscard]] double extent_mm(const Vec3& direction) const;
  /// Returns a lower bound of the distance of its points from `point`.
  [[nodiscard]] double min_distance_mm(const Vec3& point) const;
  /// Returns the corners of a box around the cylinder that stands on its disc. The cylinder is within their convex
  /// hull.
  [[nodiscard]] std::array<Vec3, 8> hull() const;
};

}  // namespace gouge
