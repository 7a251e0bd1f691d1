#pragma once

#include <cstdint>
#include <unordered_set>
#include <vector>

#include "lib/geom/vec.h"

namespace gouge {

/// Which places of space are near a set of points, in cells that double in size from level to level.
class GougedCells {
 public:
  explicit GougedCells(double finest_mm) : finest_mm_(finest_mm), levels_(kLevels) {}

  void add(const Vec3& point);

  /// True where a point lies within `reach_mm` of `at`, and for some up to four times as far away.
  [[nodiscard]] bool is_near(const Vec3& at, double reach_mm) const;

 private:
  static constexpr std::size_t kLevels = 20;

  double finest_mm_;
  std::vector<std::unordered_set<std::uint64_t>> levels_;
};

}  // namespace gouge
