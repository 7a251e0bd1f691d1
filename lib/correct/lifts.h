#pragma once

#include <vector>

namespace gouge {

/// The lifts along the tool axis that are tried one after the other, in mm: a quarter of a millimetre, and each 1.4
/// times as far as the one before, up to `max_mm`, which is the last.
[[nodiscard]] inline std::vector<double> lifts_up_to(double max_mm) {
  constexpr double kFirst_mm = 0.25, kGrowth = 1.4;
  std::vector<double> lifts;
  for (double lift = kFirst_mm; lift < max_mm; lift *= kGrowth) lifts.push_back(lift);
  lifts.push_back(max_mm);
  return lifts;
}

}  // namespace gouge
