#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "lib/head/head_body.h"
#include "lib/hierarchy/lane_bound.h"
#include "lib/hierarchy/triangles_within.h"

namespace gouge {

/// The lowest and the highest n . (x - middle) of a region, for a unit vector n in the tool's frame.
struct HeadRange {
  double low_mm = 0, high_mm = 0;
};

/// Part of a surface during a time interval, in the tool's frame. It lies within `bulge_mm` of the convex hull of its
/// positions at both ends of the interval.
struct HeadRegion {
  Vec3 middle = Vec3::Zero();
  Vec3 longest = Vec3::Zero();  ///< direction of its largest extent
  double radius_mm = 0;         ///< maximum distance of its points from the middle, at any time
  double size_mm = 0;           ///< its radius at one instant
  double travel_mm = 0;         ///< approximate maximum length of a point's path
  double bulge_mm = 0;
};

/// Region of a piece of a facet, bounded by its corners at both ends.
struct PieceRegion : HeadRegion {
  PieceRegion(const std::array<Vec3, 6>& corners, double bulge);
  [[nodiscard]] HeadRange along(const Vec3& n) const;
  /// Adds half-spaces along n that contain the region: the sides of its outline in the view along n.
  void add_sides(const Vec3& n, std::vector<HalfSpace>& sides) const;
  /// Returns the corner that is lowest along n.
  [[nodiscard]] Vec3 lowest(const Vec3& n) const;
  std::array<Vec3, 6> corners;
};

/// Region of the content of a node in the part's tree, bounded by ball and disc. `bound` and both transforms must
/// outlive it.
struct NodeRegion : HeadRegion {
  NodeRegion(const LaneBound& bound, const RigidTransform& to_tool0, const RigidTransform& to_tool1, double bulge);
  [[nodiscard]] HeadRange along(const Vec3& n) const;
  void add_sides(const Vec3& n, std::vector<HalfSpace>& sides) const;
  const LaneBound& bound;
  const RigidTransform &to_tool0, &to_tool1;
  Vec3 center0, center1;
};

/// A plane in the tool's frame. Its unit normal points out of the head.
struct HeadPlane {
  Vec3 normal = Vec3::UnitZ();
  Vec3 through = Vec3::Zero();

  /// Builds the plane at a closest point of the head, square to the direction from which that point is closest.
  explicit HeadPlane(const ClosestPoint& foot) : normal(foot.normal), through(foot.point) {}
};

/// Bounds the depth of a region in a head from above, by a plane that the head does not exceed near the region.
///
/// Let no part of the head be in a prism that stands on the plane n . x = h. The sides of the prism contain the region,
/// and its top is above it. Points of the region above the plane are then outside. From a point p below the plane, q =
/// p + (h - n . p) n is on the prism's base, and points just above q are outside. So p is no deeper than h - n . p.
///
/// Any plane is valid. A plane at the head's closest point to the region's middle, or to another point of it, is likely
/// to succeed. The head is not in the prism if its surface is not and one point of the prism is outside.
///
/// `is_middle_inside` states whether the middle is inside the head. A bound of `cutoff_mm` is as good as any smaller
/// one; if the given plane fails, it is raised to that bound.
/// Ensures  The result is nothing, or at least 0 and at least the depth of every point of the region.
/// Cost     A search or two of the head's tree, and at most as many closest points.
/// Source   docs/method/shallow_penetration.md, section 7.
[[nodiscard]] std::optional<double> depth_by_plane(const HeadBody& head, const PieceRegion& region,
                                                   const HeadPlane& plane, bool is_middle_inside, double cutoff_mm);
[[nodiscard]] std::optional<double> depth_by_plane(const HeadBody& head, const NodeRegion& region,
                                                   const HeadPlane& plane, bool is_middle_inside, double cutoff_mm);

/// Returns the same bound, at least 0, by a plane that has the whole head below it (support_planes.h).
/// Cost     A few products.
[[nodiscard]] double depth_by_support(const PieceRegion& region, const OuterPlane& plane);
[[nodiscard]] double depth_by_support(const NodeRegion& region, const OuterPlane& plane);

/// The depths below a plane of a piece's corners, at both ends of the interval.
using CornerDepths = std::array<double, 6>;

/// Returns n . x of the plane minus that of each corner; negative above the plane.
[[nodiscard]] inline CornerDepths corner_depths(const PieceRegion& region, const OuterPlane& plane) {
  CornerDepths depths;
  for (std::size_t k = 0; k < depths.size(); ++k) depths[k] = plane.height_mm - plane.normal.dot(region.corners[k]);
  return depths;
}

/// Returns a lower bound of depth_by_two_supports.
[[nodiscard]] inline double least_depth(const CornerDepths& a, const CornerDepths& b) {
  double least = 0;
  for (std::size_t k = 0; k < a.size(); ++k) least = std::max(least, std::min(a[k], b[k]));
  return least;
}

/// Returns the same bound by two planes that have the whole head below them, from the corners' depths below each. No
/// point is deeper than its depth below either plane. So no point is deeper than any mean of the two. The bound is the
/// largest mean in the piece, for the shares that make it smallest. It is much smaller than the bound of each plane alone
/// where two faces of the head are about equally near.
/// Cost     A few products.
[[nodiscard]] double depth_by_two_supports(const PieceRegion& region, const CornerDepths& a, const CornerDepths& b);

}  // namespace gouge
