#include "lib/remains/remaining_stock.h"

#include <algorithm>
#include <cmath>

#include "lib/remains/proved_region.h"
#include "lib/remains/region_mesh.h"
#include "lib/remains/stock_side.h"
#include "lib/surface/surface.h"
#include "lib/validate/bounded_volume.h"

namespace gouge {

namespace {

// Cells are at least this many times larger than the distance between the boundary and the meshes.
constexpr double kCellsOfInset = 4;

/// The grid, the question and the distance between the boundary and the meshes.
struct Plan {
  CellGrid grid;
  StockAfter after;
};

Result<Plan> plan_of(const CutHistory& history, const StockSolid& stock, std::size_t before, double resolution_mm,
                     const RemainsOptions& options) {
  const double cell = options.cell_mm > 0 ? options.cell_mm : default_stock_cell(stock, resolution_mm);
  const Vec3 size = stock.high() - stock.low();
  if (size.maxCoeff() / cell > CellGrid::kMaxCells / 2)
    return make_error("stock-cells-too-many", "the stock is more than " + std::to_string(CellGrid::kMaxCells / 2) +
                                                  " cells long; expected a larger --stock-cell");
  Plan plan{CellGrid::about(stock.low(), stock.high(), cell),
            {history, stock, before, resolution_mm, options.rounding_mm, 0}};
  plan.after.inset_mm = std::min(resolution_mm, plan.grid.size.minCoeff() / kCellsOfInset);
  return plan;
}

/// Returns the largest distance of a vertex from a surface.
double farthest_mm(const std::vector<Vec3>& vertices, const Surface& surface, const CellWork& work) {
  constexpr std::size_t kVertexChunk = 1024;
  std::vector<double> most((vertices.size() + kVertexChunk - 1) / kVertexChunk, 0);
  for_each_chunk(vertices.size(), kVertexChunk, work.threads, "comparing the meshes of the stock", work.progress,
                 [&](std::size_t first, std::size_t last) {
                   for (std::size_t i = first; i < last; ++i) {
                     const std::optional<ClosestPoint> closest = surface.closest_point(vertices[i]);
                     double& here = most[first / kVertexChunk];
                     if (closest) here = std::max(here, closest->distance_mm);
                   }
                 });
  return most.empty() ? 0 : *std::ranges::max_element(most);
}

}  // namespace

double default_stock_cell(const StockSolid& stock, double resolution_mm) {
  const double wanted = (stock.high() - stock.low()).norm() / kCellsOfDiagonal;
  if (!(wanted > 0)) return kCellsOfInset * resolution_mm;
  constexpr double kBase = 10;
  const double digit = std::pow(kBase, std::floor(std::log10(wanted)) - 1);
  return std::max(kCellsOfInset * resolution_mm, std::ceil(wanted / digit) * digit);
}

Result<RemainingStock> remaining_stock(const CutHistory& history, const StockSolid& stock, std::size_t before,
                                       double resolution_mm, const RemainsOptions& options, const CellWork& work) {
  const Result<Plan> plan = plan_of(history, stock, before, resolution_mm, options);
  if (!plan) return plan.error();
  RemainingStock remaining;
  remaining.cell_mm = plan->grid.size.maxCoeff();
  {
    const GoneSide side(plan->after);
    const Result<ProvedRegion> gone = ProvedRegion::find(plan->grid, side, plan->after.inset_mm, work);
    if (!gone) return gone.error();
    Result<IndexedMesh> mesh = mesh_of(*gone, MeshOf::rest);
    if (!mesh) return mesh.error();
    remaining.perhaps = std::move(*mesh);
    remaining.sliver_cells = gone->slivers();
  }
  const ThereSide side(plan->after);
  const Result<ProvedRegion> there = ProvedRegion::find(plan->grid, side, plan->after.inset_mm, work);
  if (!there) return there.error();
  Result<IndexedMesh> mesh = mesh_of(*there, MeshOf::region);
  if (!mesh) return mesh.error();
  remaining.surely = std::move(*mesh);
  remaining.perhaps_mm3 = detail::signed_volume(remaining.perhaps);
  remaining.surely_mm3 = detail::signed_volume(remaining.surely);
  if (!remaining.surely.triangles.empty())
    remaining.apart_mm = farthest_mm(remaining.perhaps.vertices, Surface(remaining.surely, work.threads), work);
  return remaining;
}

Result<IndexedMesh> stock_picture(const CutHistory& history, const StockSolid& stock, std::size_t before,
                                  double resolution_mm, const RemainsOptions& options, const CellWork& work) {
  const Result<Plan> plan = plan_of(history, stock, before, resolution_mm, options);
  if (!plan) return plan.error();
  const PicturedGoneSide side(plan->after);
  const Result<ProvedRegion> gone = ProvedRegion::find(plan->grid, side, plan->after.inset_mm, work);
  if (!gone) return gone.error();
  return mesh_of(*gone, MeshOf::rest);
}

}  // namespace gouge
