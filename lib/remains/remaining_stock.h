#pragma once

#include <cstddef>
#include <optional>

#include "lib/base/result.h"
#include "lib/mesh/indexed_mesh.h"
#include "lib/remains/proved_cells.h"
#include "lib/stock/cut_history.h"
#include "lib/stock/stock_solid.h"

namespace gouge {

/// Options of the meshes of the remaining stock. Lengths in mm.
struct RemainsOptions {
  double cell_mm = 0;      ///< side of the cells; 0: default_stock_cell
  double rounding_mm = 0;  ///< largest distance by which a file moves a vertex
};

/// The material that is left, between two closed meshes. Their vertices are in part coordinates, mm.
struct RemainingStock {
  IndexedMesh perhaps;                     ///< contains all material that may be there; no triangles: none is left
  IndexedMesh surely;                      ///< contains only material that is surely there; no triangles: none is
  double perhaps_mm3 = 0, surely_mm3 = 0;  ///< their volumes
  std::optional<double> apart_mm;          ///< largest distance of a vertex of `perhaps` from the surface of `surely`
  double cell_mm = 0;                      ///< longest side of the cells
  std::size_t sliver_cells = 0;  ///< cells in which material thinner than twice the resolution counts as removed
};

/// Returns the side of cells for a stock: its diagonal divided by kCellsOfDiagonal, with two digits, but at least four
/// times the resolution.
[[nodiscard]] double default_stock_cell(const StockSolid& stock, double resolution_mm);
inline constexpr double kCellsOfDiagonal = 150;

/// Returns two meshes of the material that is left after the first moves of a path.
///
/// Shape    Moves [0, before) count. `resolution_mm` is that of the history.
/// Ensures  (1) Every point of the stock that no cutter of these moves removed is in `perhaps`, except in slivers between
///          cuts (RemainingStock::sliver_cells). (2) Every point in `surely` is in the stock, and no tool reached it with
///          any body. Near motions that are not known nothing is surely there. (3) Both meshes are closed and outward,
///          and their triangles meet only at common edges. (4) They are the same at any number of threads.
/// Errors   stock-cells-too-many, stock-mesh-failed.
/// Cost     About 200 bytes and 20 microseconds for each cell on the surface, milliseconds where hundreds of moves cut it.
/// Proof    docs/method/stock_meshes.md.
[[nodiscard]] Result<RemainingStock> remaining_stock(const CutHistory& history, const StockSolid& stock,
                                                     std::size_t before, double resolution_mm,
                                                     const RemainsOptions& options, const CellWork& work);

/// Returns about the outer one of the two meshes, for a picture. Nothing is proved, so it takes less time.
[[nodiscard]] Result<IndexedMesh> stock_picture(const CutHistory& history, const StockSolid& stock, std::size_t before,
                                                double resolution_mm, const RemainsOptions& options,
                                                const CellWork& work);

}  // namespace gouge
