#include "cli/job/stock_meshes.h"

#include <algorithm>
#include <utility>

#include "lib/base/tolerance.h"
#include "lib/mesh/write_stl.h"

namespace gouge {
namespace {

// Cells for the 3D view alone are larger: fewer triangles in the page, and a quarter of the time.
constexpr double kCoarser = 2;

/// Bounds how far a point of the stock moves when it is written with single precision and read again.
double rounding_of(const StockSolid& stock, const RigidTransform& to_file) {
  const Vec3 middle = 0.5 * (stock.low() + stock.high());
  // The meshes reach less than the diagonal beyond the stock.
  const double farthest = to_file.point(middle).norm() + (stock.high() - stock.low()).norm();
  constexpr double kOfThreeAxes = 2;
  return kOfThreeAxes * Tolerance::kSingleRounding * farthest + Tolerance::kRounding_mm;
}

std::string stl_of(const IndexedMesh& mesh, const RigidTransform& to_file, LengthUnit unit) {
  if (mesh.triangles.empty()) return {};
  IndexedMesh placed = mesh;
  for (Vec3& vertex : placed.vertices) vertex = to_file.point(vertex);
  return binary_stl_bytes(placed, unit);
}

}  // namespace

Result<StockMeshes> make_stock_meshes(const JobArguments& arguments, const Job& job, const StockSetup& stock,
                                      const ProgressCall& progress) {
  const Result<double> cell = understand_stock_cell(arguments);
  if (!cell) return cell.error();
  const RigidTransform to_file = job.options.place.inverse();
  const CellWork work{job.options.check.threads, progress};
  const StockHistory programs(job.toolpath, job.options.check.law, stock);
  const CutHistory& history = programs.of_path();
  RemainsOptions options{*cell, rounding_of(stock.solid, to_file)};
  const std::size_t moves = job.toolpath.moves.size();
  StockMeshes meshes;
  if (arguments.write_stock.empty()) {
    if (!(*cell > 0)) options.cell_mm = kCoarser * default_stock_cell(stock.solid, stock.options.resolution_mm);
    Result<IndexedMesh> shown = stock_picture(history, stock.solid, moves, stock.options.resolution_mm, options, work);
    if (!shown) return shown.error();
    meshes.remaining.perhaps = std::move(*shown);
    return meshes;
  }
  Result<RemainingStock> remaining =
      remaining_stock(history, stock.solid, moves, stock.options.resolution_mm, options, work);
  if (!remaining) return remaining.error();
  meshes.remaining = std::move(*remaining);
  meshes.perhaps_stl = stl_of(meshes.remaining.perhaps, to_file, job.stl_unit(arguments));
  meshes.surely_stl = stl_of(meshes.remaining.surely, to_file, job.stl_unit(arguments));
  return meshes;
}

StockLeft StockMeshes::facts(const JobArguments& arguments) const {
  StockLeft left;
  if (!perhaps_stl.empty()) left.perhaps_file = arguments.write_stock;
  if (!surely_stl.empty()) left.surely_file = surely_file_of(arguments.write_stock);
  left.perhaps_stl = perhaps_stl;
  left.surely_stl = surely_stl;
  left.cell_mm = remaining.cell_mm;
  left.perhaps_mm3 = std::max(0.0, remaining.perhaps_mm3);
  left.surely_mm3 = std::max(0.0, remaining.surely_mm3);
  left.apart_mm = remaining.apart_mm;
  left.sliver_cells = remaining.sliver_cells;
  return left;
}

Diagnostics StockMeshes::notes(const JobArguments& arguments) const {
  Diagnostics notes;
  const std::string& file = arguments.write_stock;
  if (perhaps_stl.empty())
    notes.push_back(make_note("stock-nothing-left",
                              "no material is left of the stock, so no mesh is written; a file that is there is older",
                              file));
  if (surely_stl.empty())
    notes.push_back(make_note("stock-nothing-sure",
                              "no material is surely left, so no mesh of it is written; a file that is there is older",
                              surely_file_of(file)));
  return notes;
}

}  // namespace gouge
