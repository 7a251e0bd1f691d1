#pragma once

#include <algorithm>

namespace gouge {

/// The search for an overcut ends once its two bounds differ by no more than the larger of the absolute and the
/// relative gap.
inline constexpr double kOvercutGap_mm = 0.002, kOvercutRelativeGap = 0.01;

[[nodiscard]] inline double overcut_gap_mm(double overcut_mm) {
  return std::max(kOvercutGap_mm, kOvercutRelativeGap * overcut_mm);
}

}  // namespace gouge
