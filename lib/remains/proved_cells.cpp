#include "lib/remains/proved_cells.h"

#include <algorithm>

namespace gouge {

namespace {

enum class CubeSide : std::uint8_t { proved, other, open };

constexpr std::size_t kChunk = 64;

/// A cube of 2^level cells a side.
struct Cube {
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();

  Cube(const CellGrid& grid, const GridIndex& at, unsigned level) {
    GridIndex from = at, to = at;
    for (std::size_t k = 0; k < 3; ++k) {
      from[k] = at[k] << level;
      to[k] = std::min((at[k] + 1) << level, grid.count[k]);
    }
    low = grid.corner(from);
    high = grid.corner(to);
  }
};

CubeSide side_of(const Cube& cube, const StockSide& side) {
  const double reach = 0.5 * (cube.high - cube.low).norm();
  const double value = side.at(0.5 * (cube.low + cube.high), reach).mm;
  if (value < -reach) return CubeSide::other;
  if (!side.is_proved()) return value > reach ? CubeSide::proved : CubeSide::open;
  CutMove hint;
  if (value > 0 && side.proves(HullRegion::box(cube.low, cube.high), hint)) return CubeSide::proved;
  return CubeSide::open;
}

Diagnostic too_many() {
  return make_error("stock-cells-too-many", "the surface of the remaining stock takes more than " +
                                                std::to_string(ProvedCells::kMaxOpen) +
                                                " cells; expected a larger --stock-cell");
}

}  // namespace

Result<ProvedCells> ProvedCells::find(const CellGrid& grid, const StockSide& side, const CellWork& work) {
  unsigned level = 0;
  const std::int32_t longest = *std::ranges::max_element(grid.count);
  while ((1 << level) < longest) ++level;
  ProvedCells cells;
  cells.proved_.resize(level + 1);
  std::vector<std::uint64_t> now{grid_key({0, 0, 0})};
  for (;; --level) {
    std::vector<CubeSide> sides(now.size());
    for_each_chunk(now.size(), kChunk, work.threads, "dividing the stock", work.progress,
                   [&](std::size_t first, std::size_t last) {
                     for (std::size_t i = first; i < last; ++i)
                       sides[i] = side_of(Cube(grid, grid_index(now[i]), level), side);
                   });
    std::vector<std::uint64_t> next;
    for (std::size_t i = 0; i < now.size(); ++i) {
      if (sides[i] == CubeSide::proved) cells.proved_[level].insert(now[i]);
      if (sides[i] != CubeSide::open) continue;
      if (level == 0) {
        next.push_back(now[i]);
        continue;
      }
      const GridIndex at = grid_index(now[i]);
      for (unsigned k = 0; k < 8; ++k) {
        const GridIndex child = corner_of({2 * at[0], 2 * at[1], 2 * at[2]}, k);
        bool is_in = true;
        for (std::size_t axis = 0; axis < 3; ++axis) is_in = is_in && (child[axis] << (level - 1)) < grid.count[axis];
        if (is_in) next.push_back(grid_key(child));
      }
    }
    if (next.size() > kMaxOpen) return too_many();
    std::ranges::sort(next);
    now = std::move(next);
    if (level == 0) break;
  }
  cells.open_ = std::move(now);
  return cells;
}

bool ProvedCells::is_proved(const GridIndex& cell) const {
  GridIndex at = cell;
  for (const auto& level : proved_) {
    if (!level.empty() && level.contains(grid_key(at))) return true;
    for (std::int32_t& index : at) index >>= 1;
  }
  return false;
}

}  // namespace gouge
