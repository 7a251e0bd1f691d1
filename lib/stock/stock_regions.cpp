// The stock beside convex regions of space: StockSolid::signed_distance, is_apart_from and contains.

#include <algorithm>
#include <array>
#include <cmath>
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
  GrownRegion(const HullRegion& region, double grow_mm) : grow_mm_(grow_mm) {
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

HalfSpace behind(const HullRegion& region, const Vec3& direction) {
  double least = std::numeric_limits<double>::max();
  for (const Vec3& point : region.points()) least = std::min(least, direction.dot(point));
  return {direction, least};
}

/// A box that contains the hull of discs. One of its axes is the normal of the first disc.
struct DiscBox {
  std::array<Vec3, 3> axes;
  std::array<double, 3> low{}, high{};

  explicit DiscBox(std::span<const Disc> discs) {
    double least = std::numeric_limits<double>::max();
    const Vec3& up = discs.front().normal;
    const auto try_side = [&](const Vec3& side) {
      DiscBox box;
      box.axes = {side, Vec3(up.cross(side)), up};
      for (std::size_t k = 0; k < 3; ++k) {
        box.low[k] = std::numeric_limits<double>::max();
        box.high[k] = -box.low[k];
        for (const Disc& disc : discs) {
          box.low[k] = std::min(box.low[k], disc.lowest_mm(box.axes[k]));
          box.high[k] = std::max(box.high[k], -disc.lowest_mm(-box.axes[k]));
        }
      }
      const double size = (box.high[0] - box.low[0]) * (box.high[1] - box.low[1]);
      if (size < least) *this = box, least = size;
    };
    try_side(up.unitOrthogonal());
    for (const Disc& disc : discs.subspan(1)) {
      const Vec3 way = disc.center - discs.front().center, side = way - way.dot(up) * up;
      if (side.norm() > Tolerance::kNoSide) try_side(side.normalized());
    }
  }

  [[nodiscard]] Vec3 middle() const {
    Vec3 at = Vec3::Zero();
    for (std::size_t k = 0; k < 3; ++k) at += 0.5 * (low[k] + high[k]) * axes[k];
    return at;
  }
  /// Returns the half-spaces of the box moved out. Moved in, every point of the box stays within that distance of them.
  [[nodiscard]] std::array<HalfSpace, 6> moved_out(double by_mm) const {
    constexpr double kThin_mm = 1e-6;  // a box that has no inside would be entered by nothing
    std::array<HalfSpace, 6> space;
    for (std::size_t k = 0; k < 3; ++k) {
      const double middle = 0.5 * (low[k] + high[k]), half = 0.5 * (high[k] - low[k]);
      const double out = by_mm > 0 ? by_mm : by_mm / std::sqrt(3.0);
      const double kept = std::max(kThin_mm, half + out);
      space[2 * k] = {axes[k], middle - kept};
      space[2 * k + 1] = {Vec3(-axes[k]), -middle - kept};
    }
    return space;
  }

 private:
  DiscBox() = default;
};

}  // namespace

// Material deeper than a length in the stock has a ball of that radius about it in the stock. A point of the hull within
// that length of space outside the stock is no such material.
bool StockSolid::is_clear_of_meshes(std::span<const Disc> discs, double apart_mm) const {
  Vec3 center = Vec3::Zero();
  for (const Disc& disc : discs) center += disc.center / static_cast<double>(discs.size());
  double reach = 0;
  for (const Disc& disc : discs) reach = std::max(reach, (disc.center - center).norm() + disc.radius_mm);
  const double within = std::max(0.0, reach + apart_mm) + allowance_mm_;
  std::optional<DiscBox> box;
  for (const Surface& surface : surfaces_) {
    const Surface& boundary = surface.boundary();
    const std::optional<ClosestPoint> closest = boundary.closest_point(center, within);
    if (closest) {
      // Material at the middle that is deep enough settles it.
      const double room = std::max(0.0, -(apart_mm + allowance_mm_)) + Tolerance::kRounding_mm;
      if (closest->is_inside && closest->distance_mm > room) return false;
      // The ball about the hull meets the surface; its box may not.
      if (!box) box.emplace(discs);
      const std::array<HalfSpace, 6> moved = box->moved_out(apart_mm + allowance_mm_);
      std::array<HalfSpace, 7> space;
      std::ranges::copy(moved, space.begin());
      const bool has_plane = allowance_mm_ > 0 && apart_mm + allowance_mm_ > 0;
      if (has_plane) {
        double lowest = std::numeric_limits<double>::max();
        for (const Disc& disc : discs) lowest = std::min(lowest, disc.lowest_mm(closest->normal));
        space.back() = {closest->normal, lowest - apart_mm - allowance_mm_};
      }
      if (is_entered(boundary.tree(), {space.data(), has_plane ? space.size() : moved.size()})) return false;
    }
    if (boundary.winds_around(closest ? box->middle() : center)) return false;
  }
  return true;
}

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

bool StockSolid::is_apart_from(const HullRegion& region, double slack_mm) const {
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

bool StockSolid::contains(const HullRegion& region, double slack_mm) const {
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
