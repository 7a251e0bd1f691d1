#include "lib/head/plane_bound.h"

#include <algorithm>
#include <limits>

#include "lib/base/tolerance.h"

namespace gouge {
namespace {

constexpr double kAbove_mm = 1e-6;  // height of the base over the facet that the plane touches, and margin of the box
                                    // around the region

constexpr std::size_t kMaxSides = 8;

/// Returns a direction at right angles to n that runs along the region as far as possible.
Vec3 along_region(const Vec3& n, const Vec3& longest) {
  const Vec3 across = longest - n * n.dot(longest);
  return across.squaredNorm() > Tolerance::kNoSide * longest.squaredNorm() ? Vec3(across.normalized())
                                                                           : n.unitOrthogonal();
}

template <typename Region>
void add_slab(const Region& region, const Vec3& direction, std::vector<HalfSpace>& sides) {
  const double at = direction.dot(region.middle);
  const HeadRange range = region.along(direction);
  sides.push_back({direction, at + range.low_mm - kAbove_mm});
  sides.push_back({-direction, -at - range.high_mm - kAbove_mm});
}

template <typename Region>
std::optional<double> depth_below(const HeadBody& head, const Region& region, const HeadPlane& plane,
                                  bool is_middle_inside, double cutoff_mm) {
  const Vec3& n = plane.normal;
  const HeadRange height = region.along(n);
  std::vector<HalfSpace> prism(2);
  prism.reserve(kMaxSides + 4);
  region.add_sides(n, prism);
  const auto holds = [&](double depth_mm) {
    const double base_mm = height.low_mm + depth_mm - Tolerance::kRounding_mm;
    const double top_mm = std::max(height.high_mm, base_mm) + kAbove_mm;
    prism[0] = {n, n.dot(region.middle) + base_mm};
    prism[1] = {-n, -n.dot(region.middle) - top_mm};
    if (is_entered(head.surface.tree(), prism)) return false;
    // No surface is in the prism, so all of it is on one side. If the middle is in the prism, it shows which side.
    if (base_mm <= 0) return !is_middle_inside;
    return !head.surface.closest_point(region.middle + 0.5 * (base_mm + top_mm) * n)->is_inside;
  };
  const double touching_mm = std::max(0.0, kAbove_mm + n.dot(plane.through - region.middle) - height.low_mm);
  if (holds(touching_mm)) return touching_mm;
  if (touching_mm < cutoff_mm && holds(cutoff_mm)) return cutoff_mm;
  return std::nullopt;
}

template <typename Region>
double depth_below_support(const Region& region, const OuterPlane& plane) {
  const double low_mm = plane.normal.dot(region.middle) + region.along(plane.normal).low_mm;
  return std::max(0.0, plane.height_mm - low_mm + Tolerance::kRounding_mm);
}

/// Returns the corner at which the mean `share` a + (1 - share) b is largest.
std::size_t deepest_corner(const CornerDepths& a, const CornerDepths& b, double share) {
  std::size_t deepest = 0;
  double most = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < a.size(); ++k) {
    const double mean = share * a[k] + (1 - share) * b[k];
    if (!(mean > most)) continue;
    most = mean;
    deepest = k;
  }
  return deepest;
}

}  // namespace

PieceRegion::PieceRegion(const std::array<Vec3, 6>& at_ends, double bulge) : corners(at_ends) {
  for (const Vec3& corner : corners) middle += corner / 6.0;
  for (const Vec3& corner : corners) {
    if ((corner - middle).squaredNorm() > longest.squaredNorm()) longest = corner - middle;
  }
  bulge_mm = bulge;
  radius_mm = longest.norm() + bulge;
  const Vec3 half = (corners[0] + corners[1] + corners[2] - corners[3] - corners[4] - corners[5]) / 6.0;
  travel_mm = 2 * half.norm() + 2 * bulge;
  for (std::size_t k = 0; k < 3; ++k) size_mm = std::max(size_mm, (corners[k] - middle - half).norm());
}

HeadRange PieceRegion::along(const Vec3& n) const {
  HeadRange range{n.dot(corners[0] - middle), n.dot(corners[0] - middle)};
  for (const Vec3& corner : corners) {
    range.low_mm = std::min(range.low_mm, n.dot(corner - middle));
    range.high_mm = std::max(range.high_mm, n.dot(corner - middle));
  }
  return {range.low_mm - bulge_mm, range.high_mm + bulge_mm};
}

// Adds the sides of the outline: a line through two corners is a side if no corner is beyond it.
void PieceRegion::add_sides(const Vec3& n, std::vector<HalfSpace>& sides) const {
  const std::size_t first = sides.size();
  const Vec3 u = along_region(n, longest);
  add_slab(*this, u, sides);
  for (const Vec3& from : corners) {
    for (const Vec3& to : corners) {
      const Vec3 inward = n.cross(to - from);
      const double length = inward.norm();
      if (!(length > Tolerance::kRounding * radius_mm) || sides.size() - first >= kMaxSides) continue;
      const Vec3 direction = inward / length;
      const double low_mm = along(direction).low_mm + bulge_mm;
      if (direction.dot(from - middle) > low_mm + Tolerance::kRounding * radius_mm) continue;
      sides.push_back({direction, direction.dot(middle) + low_mm - bulge_mm - kAbove_mm});
    }
  }
}

NodeRegion::NodeRegion(const LaneBound& of, const RigidTransform& at0, const RigidTransform& at1, double bulge)
    : bound(of), to_tool0(at0), to_tool1(at1), center0(at0.point(of.center)), center1(at1.point(of.center)) {
  middle = 0.5 * (center0 + center1);
  longest = center1 - center0;
  bulge_mm = bulge;
  radius_mm = 0.5 * longest.norm() + of.radius_mm + bulge;
  size_mm = of.radius_mm;
  travel_mm = longest.norm() + 2 * bulge;
}

HeadRange NodeRegion::along(const Vec3& n) const {
  const double at0 = n.dot(center0 - middle), at1 = n.dot(center1 - middle);
  const double extent0 = bound.extent_mm(to_tool0.rotation.transpose() * n);
  const double extent1 = bound.extent_mm(to_tool1.rotation.transpose() * n);
  return {std::min(at0 - extent0, at1 - extent1) - bulge_mm, std::max(at0 + extent0, at1 + extent1) + bulge_mm};
}

void NodeRegion::add_sides(const Vec3& n, std::vector<HalfSpace>& sides) const {
  const Vec3 u = along_region(n, longest);
  add_slab(*this, u, sides);
  add_slab(*this, n.cross(u), sides);
}

Vec3 PieceRegion::lowest(const Vec3& n) const {
  return *std::min_element(corners.begin(), corners.end(),
                           [&](const Vec3& a, const Vec3& b) { return n.dot(a) < n.dot(b); });
}

std::optional<double> depth_by_plane(const HeadBody& head, const PieceRegion& region, const HeadPlane& plane,
                                     bool is_middle_inside, double cutoff_mm) {
  return depth_below(head, region, plane, is_middle_inside, cutoff_mm);
}

std::optional<double> depth_by_plane(const HeadBody& head, const NodeRegion& region, const HeadPlane& plane,
                                     bool is_middle_inside, double cutoff_mm) {
  return depth_below(head, region, plane, is_middle_inside, cutoff_mm);
}

double depth_by_support(const PieceRegion& region, const OuterPlane& plane) {
  return depth_below_support(region, plane);
}

double depth_by_support(const NodeRegion& region, const OuterPlane& plane) {
  return depth_below_support(region, plane);
}

// The largest mean is a convex function of the share. It is least where a corner at which the mean falls meets one at
// which it rises. Each pass replaces one of the two by a deeper corner; the result is valid after any number of them.
double depth_by_two_supports(const PieceRegion& region, const CornerDepths& a, const CornerDepths& b) {
  std::size_t falling = deepest_corner(a, b, 0), rising = deepest_corner(a, b, 1);
  double least = std::min(b[falling], a[rising]);
  for (std::size_t k = 0; k < a.size(); ++k) {
    const double falls = b[falling] - a[falling], rises = a[rising] - b[rising];
    if (!(falls > 0) || !(rises > 0)) break;
    const double share = std::clamp((b[falling] - b[rising]) / (falls + rises), 0.0, 1.0);
    const std::size_t deepest = deepest_corner(a, b, share);
    least = std::min(least, share * a[deepest] + (1 - share) * b[deepest]);
    if (deepest == falling || deepest == rising) break;
    (a[deepest] > b[deepest] ? rising : falling) = deepest;
  }
  return std::max(0.0, least + region.bulge_mm + Tolerance::kRounding_mm);
}

}  // namespace gouge
