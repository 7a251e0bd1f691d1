#include "lib/stock/stock_solid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "lib/base/tolerance.h"
#include "lib/hierarchy/triangles_within.h"

namespace gouge {

namespace {

/// Returns whether a closed mesh is the box about it. Its solid is in the hull of its vertices. If these are corners of
/// the box, the solid is a union of some of the few tetrahedra between them, so the volume decides.
bool is_box(const IndexedMesh& mesh) {
  const Box3 box = mesh.box();
  const auto is_corner = [&](const Vec3& v) {
    return ((v.array() <= box.min().array()) || (v.array() >= box.max().array())).all();
  };
  if (!std::all_of(mesh.vertices.begin(), mesh.vertices.end(), is_corner)) return false;
  double volume = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vec3 a = mesh.corner(t, 0) - box.min(), b = mesh.corner(t, 1) - box.min(), c = mesh.corner(t, 2) - box.min();
    volume += a.dot(b.cross(c)) / 6;
  }
  return std::abs(volume - box.volume()) < Tolerance::kSingleSum * box.volume();
}

}  // namespace

StockSolid StockSolid::box(const Vec3& low, const Vec3& high) {
  StockSolid solid;
  solid.low_ = low;
  solid.high_ = high;
  return solid;
}

Result<StockSolid> StockSolid::meshes(std::span<const IndexedMesh> meshes, double allowance_mm) {
  StockSolid solid;
  solid.allowance_mm_ = allowance_mm;
  solid.low_.setConstant(std::numeric_limits<double>::max());
  solid.high_ = -solid.low_;
  for (const IndexedMesh& mesh : meshes) {
    const Surface surface(mesh);
    if (!surface.is_solid() || !surface.boundary().is_solid()) {
      return make_error(
          "stock-open-mesh",
          "the stock is no closed mesh with outward facets, so it has no inside; expected a solid; repair "
          "it with gougecheck mesh --repair",
          mesh.name);
    }
    if (meshes.size() == 1 && !(allowance_mm > 0) && is_box(mesh)) return box(mesh.box().min(), mesh.box().max());
    solid.surfaces_.push_back(surface);
    for (const Vec3& vertex : mesh.vertices) {
      solid.low_ = solid.low_.cwiseMin(vertex);
      solid.high_ = solid.high_.cwiseMax(vertex);
    }
  }
  solid.low_ -= Vec3::Constant(allowance_mm);
  solid.high_ += Vec3::Constant(allowance_mm);
  return solid;
}

StockSolid StockSolid::solid(const Surface& boundary) {
  const Box3 box = boundary.mesh().box();
  StockSolid solid = StockSolid::box(box.min(), box.max());
  solid.surfaces_.push_back(boundary);
  return solid;
}

bool StockSolid::is_clear_of(std::span<const Disc> discs, double radius_mm) const {
  const double apart = radius_mm + Tolerance::kRounding_mm;
  for (int k = 0; k < 3; ++k) {
    const Vec3 up = Vec3::Unit(k);
    double above = std::numeric_limits<double>::max(), below = above;
    for (const Disc& disc : discs) {
      above = std::min(above, disc.lowest_mm(up) - high_[k]);
      below = std::min(below, disc.lowest_mm(-up) + low_[k]);
    }
    if (above > apart || below > apart) return true;
  }
  return !surfaces_.empty() && is_clear_of_meshes(discs, apart);
}

bool StockSolid::contains(const Vec3& point, double radius_mm) const {
  const Vec3 inset = Vec3::Constant(radius_mm + Tolerance::kRounding_mm);
  if (((point - low_ - inset).array() < 0).any() || ((high_ - inset - point).array() < 0).any()) return false;
  if (surfaces_.empty()) return true;
  for (const Surface& surface : surfaces_) {
    const std::optional<ClosestPoint> closest = surface.boundary().closest_point(point);
    if (!closest) continue;
    const double signed_mm = surface.boundary().winds_around(point) ? -closest->distance_mm : closest->distance_mm;
    if (signed_mm < allowance_mm_ - radius_mm - Tolerance::kRounding_mm) return true;
  }
  return false;
}

bool StockSolid::is_in_box(std::span<const Vec3> points) const {
  const Vec3 inset = Vec3::Constant(Tolerance::kRounding_mm);
  return std::all_of(points.begin(), points.end(), [&](const Vec3& point) {
    return ((point - low_ - inset).array() >= 0).all() && ((high_ - inset - point).array() >= 0).all();
  });
}

bool StockSolid::contains(const Vec3& from, const Vec3& to) const {
  if (!surfaces_.empty()) return contains(Vec3(0.5 * (from + to)), 0.5 * (to - from).norm());
  return is_in_box(std::array<Vec3, 2>{from, to});
}

bool StockSolid::contains(const Prism& prism) const {
  const std::array<Vec3, 6> corners = prism.corners();
  if (!is_in_box(corners)) return false;
  if (surfaces_.empty()) return true;
  const Vec3 middle = prism.middle();
  double reach = 0;
  for (const Vec3& corner : corners) reach = std::max(reach, (corner - middle).norm());
  if (contains(middle, reach)) return true;
  if (allowance_mm_ > 0) return false;
  // A prism that no facet enters is on one side of the surface.
  const std::array<HalfSpace, 5> sides = prism.sides(-Tolerance::kRounding_mm);
  return std::any_of(surfaces_.begin(), surfaces_.end(), [&](const Surface& surface) {
    const Surface& boundary = surface.boundary();
    return !is_entered(boundary.tree(), sides) && boundary.winds_around(middle);
  });
}

}  // namespace gouge
