#include "lib/path/tip_grid.h"

#include <algorithm>
#include <cmath>

namespace gouge {
namespace {

constexpr double kMinCell_mm = 1e-3;

}  // namespace

TipGrid::TipGrid(double near_mm) : near_mm_(near_mm), cell_mm_(std::max(4 * near_mm, kMinCell_mm)) {}

std::uint64_t TipGrid::cell_of(const Vec3& tip) const {
  constexpr std::uint64_t kPrimes[] = {0x9E3779B97F4A7C15U, 0xC2B2AE3D27D4EB4FU, 0x165667B19E3779F9U};
  std::uint64_t hash = 0;
  for (std::size_t k = 0; k < 3; ++k)
    hash ^= kPrimes[k] * static_cast<std::uint64_t>(
                             static_cast<std::int64_t>(std::floor(tip[static_cast<Eigen::Index>(k)] / cell_mm_)));
  return hash;
}

void TipGrid::add(const Vec3& tip, std::size_t index) { cells_[cell_of(tip)].push_back({tip, index}); }

std::vector<std::size_t> TipGrid::find(const Vec3& tip, std::size_t max_count) const {
  std::vector<std::uint64_t> cells;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 side((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1, (corner & 4) != 0 ? 1 : -1);
    cells.push_back(cell_of(tip + near_mm_ * side));
  }
  std::ranges::sort(cells);
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  std::vector<std::size_t> found;
  for (const std::uint64_t cell : cells) {
    const auto points = cells_.find(cell);
    if (points == cells_.end()) continue;
    for (const Point& point : points->second) {
      if (found.size() == max_count) break;
      if ((point.tip - tip).norm() <= near_mm_) found.push_back(point.index);
    }
  }
  std::ranges::sort(found);
  return found;
}

}  // namespace gouge
