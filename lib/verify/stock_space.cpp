#include "lib/verify/stock_space.h"

#include <algorithm>
#include <limits>
#include <numbers>
#include <span>

#include "lib/verify/bounds.h"

namespace gouge {

namespace {

/// Returns bounds of the coordinates of a block along a direction.
Bounds extent_along(const Bounds3& direction, const SpaceBlock& block) {
  Bounds half(0);
  for (const Vec3& arm : block.arms) half += CGAL::abs(dot(direction, Bounds3(arm)));
  const Bounds at = dot(direction, Bounds3(block.center));
  return {(at - half).inf(), (at + half).sup()};
}

bool are_apart(const Bounds& a, const Bounds& b) { return a.sup() < b.inf() || b.sup() < a.inf(); }

bool is_beside_box(const SpaceBlock& block, const Vec3& low, const Vec3& high) {
  for (int k = 0; k < 3; ++k) {
    const Vec3 unit = Vec3::Unit(k);
    if (are_apart(extent_along(Bounds3(unit), block), Bounds(low[k], std::max(low[k], high[k])))) return true;
  }
  const SpaceBlock box{0.5 * (low + high),
                       {Vec3::UnitX() * (0.5 * (high - low).x()), Vec3::UnitY() * (0.5 * (high - low).y()),
                        Vec3::UnitZ() * (0.5 * (high - low).z())}};
  constexpr double kRounding = 1e-9;
  return std::ranges::any_of(block.arms, [&](const Vec3& arm) {
    const Bounds3 along(arm);
    return are_apart(extent_along(along, block), widened(extent_along(along, box), kRounding * arm.norm()));
  });
}

/// Returns whether a direction separates the block and a triangle. The directions are those of the faces of both, and the
/// products of their edges.
bool is_beside_triangle(const SpaceBlock& block, const std::array<Vec3, 3>& corners) {
  const auto separates = [&](const Vec3& direction) {
    if (!(direction.squaredNorm() > 0)) return false;
    const Bounds3 along(direction);
    const Bounds a = dot(along, Bounds3(corners[0])), b = dot(along, Bounds3(corners[1])),
                 c = dot(along, Bounds3(corners[2]));
    return are_apart(extent_along(along, block), hull(hull(a, b), c));
  };
  const std::array<Vec3, 3> edges{corners[1] - corners[0], corners[2] - corners[1], corners[0] - corners[2]};
  if (std::ranges::any_of(block.arms, separates) || separates(edges[0].cross(edges[1]))) return true;
  for (const Vec3& arm : block.arms)
    for (const Vec3& edge : edges)
      if (separates(arm.cross(edge))) return true;
  return false;
}

/// Returns whether no triangle of a node enters the block.
bool is_free_of(const TriangleOrder& surface, const TriangleOrder::Node& node, const SpaceBlock& block) {
  if (node.size() == 0) return true;
  if (node.size() == 1) return is_beside_triangle(block, surface.corners(node.first));
  const TriangleOrder::Extent& extent = surface.extent(node);
  if (is_beside_box(block, extent.center - extent.half, extent.center + extent.half)) return true;
  return is_free_of(surface, {node.first, node.middle()}, block) &&
         is_free_of(surface, {node.middle(), node.last}, block);
}

}  // namespace

StockSpace::StockSpace(const ClaimedStock& stock) : stock_(stock), low_(stock.low), high_(stock.high) {
  if (!stock.solids.empty()) {
    low_ = Vec3::Constant(std::numeric_limits<double>::infinity());
    high_ = -low_;
  }
  for (const SolidDepth& solid : stock.solids) {
    surfaces_.emplace_back(std::span(&solid.mesh(), 1));
    low_ = low_.cwiseMin(solid.box().min());
    high_ = high_.cwiseMax(solid.box().max());
  }
  const double inset_mm = stock.resolution_mm - stock.allowance_mm;
  low_.array() += inset_mm;
  high_.array() -= inset_mm;
}

// A block that no triangle enters is on one side of the surface. If it is outside, so is a block that is larger by the
// resolution without the allowance, up to that depth: its points are no farther away than its corners.
bool StockSpace::is_beside(const SpaceBlock& block, bool& may_be_outside) const {
  if (is_beside_box(block, low_, high_)) return true;
  if (stock_.solids.empty() || !may_be_outside) return false;
  const double beyond_mm = stock_.allowance_mm - stock_.resolution_mm;
  const SpaceBlock around = block.grown(beyond_mm > 0 ? beyond_mm : beyond_mm / std::numbers::sqrt3);
  for (std::size_t k = 0; k < surfaces_.size(); ++k) {
    if (!is_free_of(surfaces_[k], surfaces_[k].root(), around)) return false;
    if (stock_.solids[k].is_outside(around.center)) continue;
    may_be_outside = beyond_mm < 0 && !is_free_of(surfaces_[k], surfaces_[k].root(), block);
    return false;
  }
  return true;
}

}  // namespace gouge
