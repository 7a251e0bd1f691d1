#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "postproc/result/stored_result.h"

namespace gouge {

/// The witnesses of findings by place, so that those near a point are found without looking at all.
class WitnessGrid {
 public:
  struct Near {
    std::size_t finding = 0;
    const StoredMove* move = nullptr;
  };

  /// Of these findings, for points up to `reach_mm` (above 0) away. `result` must outlive it.
  WitnessGrid(const StoredResult& result, const std::vector<std::size_t>& findings, double reach_mm);

  /// Calls `call(near, distance in mm)` for each within reach, in an order that depends on the witnesses alone.
  template <class Call>
  void for_each_near(const Vec3& point, Call&& call) const {
    const Cell middle = cell_of(point);
    for (int n = 0; n < 27; ++n) {
      const auto found = cells_.find({middle[0] + n % 3 - 1, middle[1] + n / 3 % 3 - 1, middle[2] + n / 9 - 1});
      if (found == cells_.end()) continue;
      for (const Near& near : found->second) {
        const double apart_mm = (near.move->witness->point - point).norm();
        if (apart_mm <= reach_mm_) call(near, apart_mm);
      }
    }
  }

 private:
  using Cell = std::array<std::int64_t, 3>;
  [[nodiscard]] Cell cell_of(const Vec3& point) const;

  double reach_mm_;
  std::map<Cell, std::vector<Near>> cells_;
};

}  // namespace gouge
