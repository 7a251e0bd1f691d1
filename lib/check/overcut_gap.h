#pragma once

#include <algorithm>

namespace gouge {

/// Overcuts are searched until their two bounds are no farther apart than the larger of these.
inline constexpr double kOvercutGap_mm = 0.002, kOvercutRelativeGap = 0.01;

[[nodiscard]] inline double overcut_gap_mm(double overcut_mm) {
  return std::max(kOvercutGap_mm, kOvercutRelativeGap * overcut_mm);
}

}  // namespace gouge
