#include "lib/stock/stock_solid.h"

#include <limits>

#include "lib/base/tolerance.h"

namespace gouge {

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

bool StockSolid::contains(const Vec3& point) const {
  const Vec3 inset = Vec3::Constant(Tolerance::kRounding_mm);
  if (((point - low_ - inset).array() < 0).any() || ((high_ - inset - point).array() < 0).any()) return false;
  if (surfaces_.empty()) return true;
  for (const Surface& surface : surfaces_) {
    const std::optional<ClosestPoint> closest = surface.boundary().closest_point(point);
    if (!closest) continue;
    const double signed_mm = surface.boundary().winds_around(point) ? -closest->distance_mm : closest->distance_mm;
    if (signed_mm < allowance_mm_ - Tolerance::kRounding_mm) return true;
  }
  return false;
}

}  // namespace gouge
