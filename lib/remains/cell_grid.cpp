#include "lib/remains/cell_grid.h"

#include <algorithm>
#include <cmath>

namespace gouge {

GridIndex grid_index(std::uint64_t key) {
  constexpr std::uint64_t kMask = (1ULL << 21U) - 1;
  return {static_cast<std::int32_t>(key & kMask) - 1, static_cast<std::int32_t>((key >> 21U) & kMask) - 1,
          static_cast<std::int32_t>(key >> 42U) - 1};
}

CellGrid CellGrid::about(const Vec3& low, const Vec3& high, double cell_mm) {
  CellGrid grid;
  for (int k = 0; k < 3; ++k) {
    const double length = high[k] - low[k];
    const double parts = std::max(1.0, std::ceil(length / cell_mm));
    grid.size[k] = length > 0 ? length / parts : cell_mm;
    grid.origin[k] = low[k] - 1.5 * grid.size[k];
    grid.count[static_cast<std::size_t>(k)] = static_cast<std::int32_t>(parts) + 3;
  }
  return grid;
}

}  // namespace gouge
