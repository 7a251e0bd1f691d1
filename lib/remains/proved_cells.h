#pragma once

#include <cstdint>
#include <optional>
#include <unordered_set>
#include <vector>

#include "lib/base/parallel.h"
#include "lib/base/result.h"
#include "lib/remains/cell_grid.h"
#include "lib/remains/stock_side.h"

namespace gouge {

/// Threads and progress of the work on cells.
struct CellWork {
  unsigned threads = 0;
  ProgressCall progress;
};

/// The cells of a grid by their side: large cubes of cells are proved to be on a side as one, or are surely not on it.
class ProvedCells {
 public:
  /// Divides the grid from the whole to single cells. A cube that is neither proved nor far on the other side is divided.
  /// Errors: stock-cells-too-many.
  [[nodiscard]] static Result<ProvedCells> find(const CellGrid& grid, const StockSide& side, const CellWork& work);

  /// Returns the cells that are left, by their keys, in increasing order.
  [[nodiscard]] const std::vector<std::uint64_t>& open() const { return open_; }
  /// Returns whether a cell is in a proved cube.
  [[nodiscard]] bool is_proved(const GridIndex& cell) const;

  static constexpr std::size_t kMaxOpen = 8'000'000;

 private:
  std::vector<std::unordered_set<std::uint64_t, GridHash>> proved_;  // cubes of 2^level cells a side, for each level
  std::vector<std::uint64_t> open_;
};

}  // namespace gouge
