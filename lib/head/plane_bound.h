#pragma once

#include <array>
#include <optional>
#include <vector>

#include "lib/head/head_body.h"
#include "lib/hierarchy/lane_bound.h"
#include "lib/hierarchy/triangles_within.h"

namespace gouge {

/// From the lowest to the highest n . (x - middle) of a region, for a unit n in the tool's frame.
struct HeadRange {
  double low_mm = 0, high_mm = 0;
};

/// Part of a surface during a time interval, in the tool's frame. It lies within `bulge_mm` of the convex hull of its
/// positions at both ends of the interval.
struct HeadRegion {
  Vec3 middle = Vec3::Zero();
  Vec3 longest = Vec3::Zero();  ///< the direction it extends in
  double radius_mm = 0;         ///< no point of it is farther from the middle, at any time
  double size_mm = 0;           ///< its radius at one instant
  double travel_mm = 0;         ///< no point of it goes much farther
  double bulge_mm = 0;
};

/// Bounds a piece of a facet by its corners at both ends.
struct PieceRegion : HeadRegion {
  PieceRegion(const std::array<Vec3, 6>& corners, double bulge);
  [[nodiscard]] HeadRange along(const Vec3& n) const;
  /// Adds half-spaces along n that hold it: of the outline that it has seen along n.
  void add_sides(const Vec3& n, std::vector<HalfSpace>& sides) const;
  /// Returns the corner that is lowest along n.
  [[nodiscard]] Vec3 lowest(const Vec3& n) const;
  std::array<Vec3, 6> corners;
};

/// Bounds the content of a node of the part's tree by its ball and disc. `bound` and both transforms must outlive it.
struct NodeRegion : HeadRegion {
  NodeRegion(const LaneBound& bound, const RigidTransform& to_tool0, const RigidTransform& to_tool1, double bulge);
  [[nodiscard]] HeadRange along(const Vec3& n) const;
  void add_sides(const Vec3& n, std::vector<HalfSpace>& sides) const;
  const LaneBound& bound;
  const RigidTransform &to_tool0, &to_tool1;
  Vec3 center0, center1;
};

/// A plane of the tool's frame, its unit normal out of the head.
struct HeadPlane {
  Vec3 normal = Vec3::UnitZ();
  Vec3 through = Vec3::Zero();

  /// The one at a closest point of the head, square to the direction from there.
  explicit HeadPlane(const ClosestPoint& foot) : normal(foot.normal), through(foot.point) {}
};

/// Bounds the depth of a region in a head from above, by a plane that the head does not rise above near the region.
///
/// Let no part of the head be in a prism that stands on the plane n . x = h. The sides of the prism hold the region,
/// and its top is above it. Points of the region above the plane are then outside. From a point p below the plane, q =
/// p + (h - n . p) n is on the prism's base, and points just above q are outside. So p is no deeper than h - n . p.
///
/// Any plane will do. One at the head's closest point to the region's middle, or to another point of it, is likely to
/// hold. The head is not in the prism if its surface is not and one point of the prism is outside.
///
/// The flag `is_middle_inside` is of the head. A bound of `cutoff_mm` is as good as any smaller one. The plane is
/// raised to it where the given one does not hold.
/// Ensures  Nothing, or at least 0 and not below the depth of any point of the region.
/// Cost     A search of the head's tree or two, and at most as many closest points.
/// Source   docs/method/shallow_penetration.md, section 7.
[[nodiscard]] std::optional<double> depth_by_plane(const HeadBody& head, const PieceRegion& region,
                                                   const HeadPlane& plane, bool is_middle_inside, double cutoff_mm);
[[nodiscard]] std::optional<double> depth_by_plane(const HeadBody& head, const NodeRegion& region,
                                                   const HeadPlane& plane, bool is_middle_inside, double cutoff_mm);

/// Returns the same by a plane that all of the head is below (support_planes.h), at least 0.
/// Cost     A few products.
[[nodiscard]] double depth_by_support(const PieceRegion& region, const OuterPlane& plane);
[[nodiscard]] double depth_by_support(const NodeRegion& region, const OuterPlane& plane);

}  // namespace gouge
