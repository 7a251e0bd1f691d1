#include "lib/stock/stock_shape.h"

#include <limits>
#include <utility>

#include "lib/base/number_text.h"

namespace gouge {
namespace {

std::string point_text(const Vec3& p) {
  constexpr int kDecimals = 3;
  return display_text(p.x(), kDecimals) + "," + display_text(p.y(), kDecimals) + "," + display_text(p.z(), kDecimals);
}

DescribedStock box_about(std::span<const IndexedMesh> parts, double margin_mm) {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::max()), high = -low;
  for (const IndexedMesh& part : parts) {
    for (const Vec3& vertex : part.vertices) {
      low = low.cwiseMin(vertex);
      high = high.cwiseMax(vertex);
    }
  }
  const Vec3 margin = Vec3::Constant(margin_mm);
  low -= margin;
  high += margin;
  return {StockSolid::box(low, high),
          "the box from " + point_text(low) + " to " + point_text(high) + " mm about the part"};
}

}  // namespace

Result<DescribedStock> make_stock(const StockShape& shape, std::span<const IndexedMesh> meshes,
                                  const std::string& name) {
  if (shape.kind == StockShape::Kind::box) return box_about(meshes, shape.allowance_mm);
  Result<StockSolid> solid = StockSolid::meshes(meshes, shape.allowance_mm);
  if (!solid) return solid.error();
  const bool is_part = shape.kind == StockShape::Kind::part;
  return DescribedStock{std::move(*solid),
                        is_part ? "the part with an allowance of " + exact_text(shape.allowance_mm) + " mm" : name};
}

}  // namespace gouge
