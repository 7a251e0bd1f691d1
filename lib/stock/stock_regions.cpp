// The stock beside convex regions of space: StockSolid::signed_distance, is_apart_from and contains.

#include <array>
#include <limits>
#include <span>

#include "lib/base/tolerance.h"
#include "lib/geom/point_triangle.h"
#include "lib/hierarchy/triangles_within.h"
#include "lib/stock/stock_solid.h"

namespace gouge {

namespace {

/// Half-spaces whose intersection contains a region, grown by a length in all directions.
class GrownRegion {
 public:
  GrownRegion(const ConvexRegion& region, double grow_mm) : grow_mm_(grow_mm) {
    const Vec3 low = region.low(), high = region.high();
    for (int k = 0; k < 3; ++k) {
      add({Vec3::Unit(k), low[k]});
      add({-Vec3::Unit(k), -high[k]});
    }
    for (std::size_t k = 0; k < region.face_count; ++k) add(region.faces[k]);
  }

  void add(const HalfSpace& half) { space_[count_++] = {half.direction, half.min_mm - grow_mm_}; }
  [[nodiscard]] std::span<const HalfSpace> space() const { return {space_.data(), count_}; }

 private:
  double grow_mm_;
  std::array<HalfSpace, kMaxHalfSpaces> space_;
  std::size_t count_ = 0;
};

HalfSpace behind(const ConvexRegion& region, const Vec3& direction) {
  double least = std::numeric_limits<double>::max();
  for (const Vec3& point : region.points()) least = std::min(least, direction.dot(point));
  return {direction, least};
}

}  // namespace

StockSolid::Distance StockSolid::signed_distance(const Vec3& point) const {
  Distance nearest{-std::numeric_limits<double>::max(), Vec3::UnitZ()};
  if (surfaces_.empty()) {
    for (int k = 0; k < 3; ++k) {
      if (point[k] - high_[k] > nearest.mm) nearest = {point[k] - high_[k], Vec3::Unit(k)};
      if (low_[k] - point[k] > nearest.mm) nearest = {low_[k] - point[k], Vec3(-Vec3::Unit(k))};
    }
    return nearest;
  }
  nearest.mm = std::numeric_limits<double>::max();
  for (const Surface& surface : surfaces_) {
    const std::optional<ClosestPoint> closest = surface.boundary().closest_point(point);
    if (!closest || closest->signed_mm() - allowance_mm_ >= nearest.mm) continue;
    nearest = {closest->signed_mm() - allowance_mm_, closest->normal};
  }
  return nearest;
}

bool StockSolid::is_apart_from(const ConvexRegion& region, double slack_mm) const {
  const double apart = slack_mm + Tolerance::kRounding_mm;
  if (((region.low() - high_).array() >= apart).any() || ((low_ - region.high()).array() >= apart).any()) return true;
  if (surfaces_.empty()) return false;
  const Vec3 middle = region.middle();
  for (const Surface& surface : surfaces_) {
    const Surface& boundary = surface.boundary();
    GrownRegion grown(region, allowance_mm_ + apart);
    if (allowance_mm_ > 0) {
      const std::optional<ClosestPoint> closest = boundary.closest_point(middle);
      if (closest) grown.add(behind(region, closest->normal));
    }
    if (is_entered(boundary.tree(), grown.space()) || boundary.winds_around(middle)) return false;
  }
  return true;
}

bool StockSolid::contains(const ConvexRegion& region, double slack_mm) const {
  const double inset = slack_mm + Tolerance::kRounding_mm;
  if (surfaces_.empty())
    return ((region.low() - low_).array() >= inset).all() && ((high_ - region.high()).array() >= inset).all();
  const Vec3 middle = region.middle();
  for (const Surface& surface : surfaces_) {
    const Surface& boundary = surface.boundary();
    if (!is_entered(boundary.tree(), GrownRegion(region, inset).space()) && boundary.winds_around(middle)) return true;
    if (!(allowance_mm_ > inset)) continue;
    // The distance from one triangle is a convex function, so it is largest at a corner.
    const std::optional<ClosestPoint> closest = boundary.closest_point(middle);
    if (!closest) continue;
    const std::array<Vec3, 3> triangle = boundary.corners(closest->triangle);
    const double within = allowance_mm_ - inset;
    const auto is_near = [&](const Vec3& point) {
      return closest_on_triangle(point, triangle).distance2_mm2 <= within * within;
    };
    if (std::ranges::all_of(region.points(), is_near)) return true;
  }
  return false;
}

}  // namespace gouge
