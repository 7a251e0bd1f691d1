#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "lib/geom/vec.h"

namespace gouge {

/// The convex hull of a few points, in mm: a plane polygon with its corners in order, or a box.
class ConvexRegion {
 public:
  static constexpr std::size_t kMaxPoints = 8;

  ConvexRegion() { points_.fill(Vec3::Zero()); }

  /// Adds a point. Requires fewer than kMaxPoints points before.
  void add(const Vec3& point) { points_[count_++] = point; }
  [[nodiscard]] std::span<const Vec3> points() const { return std::span(points_).first(count_); }

  [[nodiscard]] Vec3 centre() const;
  /// Returns an upper bound of the distance of the region's points from `centre`.
  [[nodiscard]] double radius_mm(const Vec3& centre) const;
  [[nodiscard]] Box3 box() const;
  /// Returns the area. Requires a polygon.
  [[nodiscard]] double area_mm2() const;

 private:
  std::array<Vec3, kMaxPoints> points_;
  std::size_t count_ = 0;
};

[[nodiscard]] ConvexRegion region_of_box(const Box3& box);

/// Returns the two halves of a box, cut across its longest side.
[[nodiscard]] std::array<Box3, 2> halves(const Box3& box);

/// Returns two parts that together cover a polygon. The cut is across the longest extent, or from one corner to another
/// if the polygon has many corners.
[[nodiscard]] std::vector<ConvexRegion> halves(const ConvexRegion& polygon);

/// Cuts a polygon by the three planes that stand on a triangle's edges. Returns first the part over the triangle, then
/// the others. Returns the polygon itself if nothing is cut off, if nothing lies over the triangle, or if the polygon
/// has many corners.
/// Ensures  No point of the polygon is farther than 1e-10 mm from the parts.
[[nodiscard]] std::vector<ConvexRegion> cut_along(const ConvexRegion& polygon, const std::array<Vec3, 3>& triangle);

}  // namespace gouge
