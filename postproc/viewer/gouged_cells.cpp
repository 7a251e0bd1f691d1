#include "postproc/viewer/gouged_cells.h"

#include <cmath>

namespace gouge {
namespace {

struct Cell {
  std::int64_t x, y, z;
  [[nodiscard]] std::uint64_t key() const {
    constexpr std::int64_t kMiddle = 1 << 20;
    constexpr std::uint64_t kMask = (1U << 21) - 1;
    const auto part = [&](std::int64_t v) { return static_cast<std::uint64_t>(v + kMiddle) & kMask; };
    return part(x) << 42 | part(y) << 21 | part(z);
  }
};

Cell cell_of(const Vec3& p, double side) {
  return {static_cast<std::int64_t>(std::floor(p.x() / side)), static_cast<std::int64_t>(std::floor(p.y() / side)),
          static_cast<std::int64_t>(std::floor(p.z() / side))};
}

bool has_any(const std::unordered_set<std::uint64_t>& cells, const Cell& low, const Cell& high) {
  for (std::int64_t x = low.x; x <= high.x; ++x) {
    for (std::int64_t y = low.y; y <= high.y; ++y) {
      for (std::int64_t z = low.z; z <= high.z; ++z) {
        if (cells.contains(Cell{x, y, z}.key())) return true;
      }
    }
  }
  return false;
}

}  // namespace

void GougedCells::add(const Vec3& point) {
  double side = finest_mm_;
  for (auto& level : levels_) {
    if (!level.insert(cell_of(point, side).key()).second) return;  // then all levels above have it too
    side *= 2;
  }
}

bool GougedCells::is_near(const Vec3& at, double reach_mm) const {
  double side = finest_mm_;
  std::size_t level = 0;
  while (side < reach_mm && level + 1 < levels_.size()) {
    side *= 2;
    ++level;
  }
  const Cell c = cell_of(at, side);
  // A cell that has a point lies in larger ones that have it too: mostly one of those is looked at, and found empty.
  for (const std::size_t up : {std::size_t{4}, std::size_t{2}, std::size_t{0}}) {
    if (level + up >= levels_.size()) continue;
    if (!has_any(levels_[level + up], {(c.x - 1) >> up, (c.y - 1) >> up, (c.z - 1) >> up},
                 {(c.x + 1) >> up, (c.y + 1) >> up, (c.z + 1) >> up}))
      return false;
  }
  return true;
}

}  // namespace gouge
