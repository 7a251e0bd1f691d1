#pragma once

#include <vector>

namespace gouge {

/// Returns the lifts along the tool axis that are tried one after the other, in mm. The first is a quarter of a
/// millimetre, and each is 1.4 times the one before. The last is `max_mm`.
[[nodiscard]] inline std::vector<double> lifts_up_to(double max_mm) {
  constexpr double kFirst_mm = 0.25, kGrowth = 1.4;
  std::vector<double> lifts;
  for (double lift = kFirst_mm; lift < max_mm; lift *= kGrowth) lifts.push_back(lift);
  lifts.push_back(max_mm);
  return lifts;
}

}  // namespace gouge
