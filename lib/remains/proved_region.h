#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "lib/remains/cell_grid.h"
#include "lib/remains/proved_cells.h"
#include "lib/remains/region_points.h"
#include "lib/remains/stock_side.h"

namespace gouge {

/// A region of space that is proved to be on one side of the boundary of the remaining stock, as large as the cells of a
/// grid allow. Each cell belongs to it, does not belong to it, or is divided by a surface.
///
/// Requires that the outermost cells of the grid are all on the side, or all not.
/// Source   docs/method/stock_meshes.md.
class ProvedRegion {
 public:
  /// Errors: stock-cells-too-many.
  [[nodiscard]] static Result<ProvedRegion> find(const CellGrid& grid, const StockSide& side, double inset_mm,
                                                 const CellWork& work);

  /// Returns the cells that a surface divides, by their keys, in increasing order.
  [[nodiscard]] std::vector<std::uint64_t> divided_cells() const;
  [[nodiscard]] const RegionPoints& points() const { return points_; }
  /// Returns the number of cells with pieces that are proved only with cutters that are wider by the resolution.
  [[nodiscard]] std::size_t slivers() const;

 private:
  enum class Proof : std::uint8_t { none, failed, exact, widened };
  using Keys = std::vector<std::uint64_t>;

  ProvedRegion(const CellGrid& grid, const StockSide& side, double inset_mm, const CellWork& work, ProvedCells cells)
      : side_(side), work_(work), cells_(std::move(cells)), points_(grid, side, inset_mm), inset_mm_(inset_mm) {}
  void open(const Keys& cells);
  void open_beside(const Keys& corners);
  [[nodiscard]] bool make_simple();
  void leave(std::uint64_t corner);
  [[nodiscard]] bool prove_all();
  [[nodiscard]] Proof prove(const GridIndex& cell) const;
  [[nodiscard]] std::uint64_t worst_corner(const GridIndex& cell) const;
  void doubt_about(const GridIndex& cell);

  const StockSide& side_;
  CellWork work_;
  ProvedCells cells_;
  RegionPoints points_;
  double inset_mm_;
  std::unordered_map<std::uint64_t, Proof, GridHash> proofs_;  // of the cells that were opened
  Keys waiting_;                                               // cells without a proof; may repeat
  Keys unshaped_;                                              // cells whose corners may divide them in two places
};

}  // namespace gouge
