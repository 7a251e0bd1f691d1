#include "postproc/compare/witness_grid.h"

#include <algorithm>
#include <cmath>

namespace gouge {

WitnessGrid::WitnessGrid(const StoredResult& result, const std::vector<std::size_t>& findings, double reach_mm)
    : reach_mm_(reach_mm) {
  for (const std::size_t k : findings) {
    for (const StoredMove* move : result.moves_of(result.findings[k])) {
      if (move->witness) cells_[cell_of(move->witness->point)].push_back({k, move});
    }
  }
}

WitnessGrid::Cell WitnessGrid::cell_of(const Vec3& point) const {
  constexpr double kFarthest = 1e15;  // within what an integer holds
  Cell cell{};
  for (std::size_t k = 0; k < cell.size(); ++k) {
    const double at = std::floor(point[static_cast<Eigen::Index>(k)] / reach_mm_);
    cell.at(k) = static_cast<std::int64_t>(std::clamp(at, -kFarthest, kFarthest));
  }
  return cell;
}

}  // namespace gouge
