#include "lib/stock/excess_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "lib/geom/triangle.h"
#include "lib/mesh/union_find.h"

namespace gouge {

namespace {

constexpr std::uint32_t kNoPlace = std::numeric_limits<std::uint32_t>::max();

using Cell = std::array<std::int32_t, 3>;

struct CellOfPiece {
  Cell cell;
  std::uint32_t piece;
  bool operator<(const CellOfPiece& other) const {
    return cell != other.cell ? cell < other.cell : piece < other.piece;
  }
};

/// Adds the cells of a triangle, divided until its parts are smaller than a cell.
void add_cells(const std::array<Vec3, 3>& corners, std::uint32_t piece, double cell_mm, std::vector<CellOfPiece>& all) {
  const std::size_t edge = longest_edge(corners);
  if ((corners[(edge + 1) % 3] - corners[edge]).norm() > cell_mm) {
    for (const auto& half : halves(corners, edge)) add_cells(half, piece, cell_mm, all);
    return;
  }
  const Vec3 middle = (corners[0] + corners[1] + corners[2]) / 3;
  CellOfPiece one{{}, piece};
  for (std::size_t k = 0; k < 3; ++k)
    one.cell[k] = static_cast<std::int32_t>(std::floor(middle[static_cast<int>(k)] / cell_mm));
  if (all.empty() || all.back().cell != one.cell || all.back().piece != piece) all.push_back(one);
}

}  // namespace

std::vector<std::uint32_t> places_of(std::span<const LeftPiece> pieces, double cell_mm) {
  std::vector<CellOfPiece> cells;
  for (std::uint32_t p = 0; p < pieces.size(); ++p) add_cells(pieces[p].piece.corners, p, cell_mm, cells);
  std::sort(cells.begin(), cells.end());
  UnionFind sets(pieces.size());
  const auto join_all = [&](std::uint32_t piece, const Cell& cell) {
    const CellOfPiece first{cell, 0};
    const auto at = std::lower_bound(cells.begin(), cells.end(), first);
    if (at != cells.end() && at->cell == cell) sets.join(piece, at->piece);
  };
  for (std::size_t k = 0; k < cells.size(); ++k) {
    if (k > 0 && cells[k].cell == cells[k - 1].cell) {
      sets.join(cells[k].piece, cells[k - 1].piece);
      continue;
    }
    // Half of the neighbours: the others meet this cell from their side.
    for (int n = 0; n < 13; ++n) {
      const Cell& c = cells[k].cell;
      join_all(cells[k].piece, {c[0] + n / 9 - 1, c[1] + n / 3 % 3 - 1, c[2] + n % 3 - 1});
    }
  }
  std::vector<std::uint32_t> place_of_root(pieces.size(), kNoPlace), places;
  std::uint32_t count = 0;
  for (std::uint32_t p = 0; p < pieces.size(); ++p) {
    std::uint32_t& place = place_of_root[sets.root(p)];
    if (place == kNoPlace) place = count++;
    places.push_back(place);
  }
  return places;
}

}  // namespace gouge
