#include "lib/clash/convex_region.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lib/base/tolerance.h"

namespace gouge {
namespace {

constexpr double kOnPlane_mm =
    Tolerance::kConstruction;  // a corner this near to a plane counts as on it, so that no slivers are cut off

/// Signed distances of a polygon's corners from a plane.
using Heights = std::array<double, ConvexRegion::kMaxPoints>;

Heights heights_over(const ConvexRegion& polygon, const Vec3& normal, const Vec3& origin) {
  Heights heights{};
  std::size_t k = 0;
  for (const Vec3& point : polygon.points()) {
    const double height = normal.dot(point - origin);
    heights[k++] = std::abs(height) <= kOnPlane_mm ? 0 : height;
  }
  return heights;
}

/// Returns the part on the side of `sign`; empty if it has no extent across the plane.
ConvexRegion clipped(const ConvexRegion& polygon, const Heights& heights, double sign) {
  ConvexRegion part;
  const std::span<const Vec3> points = polygon.points();
  bool has_extent = false;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const std::size_t next = (k + 1) % points.size();
    const double here = sign * heights[k], there = sign * heights[next];
    has_extent = has_extent || here > 0;
    if (here >= 0) part.add(points[k]);
    if ((here > 0 && there < 0) || (here < 0 && there > 0))
      part.add(points[k] + here / (here - there) * (points[next] - points[k]));
  }
  return has_extent ? part : ConvexRegion();
}

}  // namespace

Vec3 ConvexRegion::centre() const {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& point : points()) sum += point;
  return sum / static_cast<double>(count_);
}

double ConvexRegion::radius_mm(const Vec3& centre) const {
  double radius2 = 0;
  for (const Vec3& point : points()) radius2 = std::max(radius2, (point - centre).squaredNorm());
  return std::sqrt(radius2);
}

Box3 ConvexRegion::box() const {
  Box3 box;
  for (const Vec3& point : points()) box.extend(point);
  return box;
}

double ConvexRegion::area_mm2() const {
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 2; k < count_; ++k) sum += (points_[k - 1] - points_[0]).cross(points_[k] - points_[0]);
  return 0.5 * sum.norm();
}

ConvexRegion region_of_box(const Box3& box) {
  ConvexRegion region;
  for (unsigned k = 0; k < 8; ++k) {
    region.add(Vec3((k & 1U) != 0 ? box.max().x() : box.min().x(), (k & 2U) != 0 ? box.max().y() : box.min().y(),
                    (k & 4U) != 0 ? box.max().z() : box.min().z()));
  }
  return region;
}

std::array<Box3, 2> halves(const Box3& box) {
  int axis = 0;
  box.sizes().maxCoeff(&axis);
  std::array<Box3, 2> parts{box, box};
  parts[0].max()[axis] = parts[1].min()[axis] = box.center()[axis];
  return parts;
}

std::vector<ConvexRegion> halves(const ConvexRegion& polygon) {
  const std::span<const Vec3> points = polygon.points();
  if (points.size() + 1 > ConvexRegion::kMaxPoints) {
    std::vector<ConvexRegion> parts(2);
    const std::size_t middle = points.size() / 2;
    for (std::size_t k = 0; k <= middle; ++k) parts[0].add(points[k]);
    for (std::size_t k = middle; k <= points.size(); ++k) parts[1].add(points[k % points.size()]);
    return parts;
  }
  std::pair<std::size_t, std::size_t> ends{0, 0};
  double longest2 = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double length2 = (points[i] - points[j]).squaredNorm();
      if (!(length2 > longest2)) continue;
      longest2 = length2;
      ends = {i, j};
    }
  }
  const Vec3 along = points[ends.first] - points[ends.second];
  const Heights heights = heights_over(polygon, along / std::max(std::sqrt(longest2), kOnPlane_mm),
                                       0.5 * (points[ends.first] + points[ends.second]));
  std::vector<ConvexRegion> parts;
  for (const double sign : {1.0, -1.0}) {
    const ConvexRegion part = clipped(polygon, heights, sign);
    if (!part.points().empty()) parts.push_back(part);
  }
  return parts;
}

std::vector<ConvexRegion> cut_along(const ConvexRegion& polygon, const std::array<Vec3, 3>& triangle) {
  if (polygon.points().size() + 3 > ConvexRegion::kMaxPoints) return {polygon};
  const Vec3 normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
  std::vector<ConvexRegion> parts(1, polygon);
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 outward = (triangle[(k + 1) % 3] - triangle[k]).cross(normal);
    if (!(outward.norm() > 0)) return {polygon};
    const Heights heights = heights_over(parts[0], outward.normalized(), triangle[k]);
    const ConvexRegion beyond = clipped(parts[0], heights, 1);
    const ConvexRegion over = clipped(parts[0], heights, -1);
    if (over.points().empty()) return {polygon};
    parts[0] = over;
    if (!beyond.points().empty()) parts.push_back(beyond);
  }
  return parts;
}

}  // namespace gouge
