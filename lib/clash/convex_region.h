#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "lib/geom/vec.h"

namespace gouge {

/// The convex hull of a few points: a plane polygon, its corners in order, or a box. mm.
class ConvexRegion {
 public:
  static constexpr std::size_t kMaxPoints = 8;

  ConvexRegion() { points_.fill(Vec3::Zero()); }

  /// Requires fewer than kMaxPoints so far.
  void add(const Vec3& point) { points_[count_++] = point; }
  [[nodiscard]] std::span<const Vec3> points() const { return std::span(points_).first(count_); }

  [[nodiscard]] Vec3 centre() const;
  /// Returns a distance from `centre` that no point of the region exceeds.
  [[nodiscard]] double radius_mm(const Vec3& centre) const;
  [[nodiscard]] Box3 box() const;
  /// Builds the region of a polygon.
  [[nodiscard]] double area_mm2() const;

 private:
  std::array<Vec3, kMaxPoints> points_;
  std::size_t count_ = 0;
};

[[nodiscard]] ConvexRegion region_of_box(const Box3& box);

/// Returns both halves of a box across its longest side.
[[nodiscard]] std::array<Box3, 2> halves(const Box3& box);

/// Returns a polygon in two, which cover it: across its longest extent, or where it has many corners from one to
/// another.
[[nodiscard]] std::vector<ConvexRegion> halves(const ConvexRegion& polygon);

/// Returns a polygon cut by the three planes that stand on a triangle's edges: first what lies over the triangle, then
/// the rest. One part, the polygon itself, where nothing is cut off, nothing lies over the triangle or it has many
/// corners.
/// Ensures  No point of the polygon is farther than 1e-10 mm from the parts.
[[nodiscard]] std::vector<ConvexRegion> cut_along(const ConvexRegion& polygon, const std::array<Vec3, 3>& triangle);

}  // namespace gouge
