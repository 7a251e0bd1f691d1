#include "lib/motion/chord_instants.h"

#include <algorithm>
#include <cmath>

namespace gouge {

std::vector<double> chord_instants(const Motion& motion, double error_mm, std::size_t most) {
  std::vector<double> instants;
  std::uint32_t number = 0;
  for (const MotionSegment& segment : motion.segments()) {
    const double sag_mm = motion.sag_mm(segment.t0, segment.t1, number++);
    // The sag falls with the square of the interval.
    const double wanted = std::clamp(std::ceil(std::sqrt(sag_mm / error_mm)), 1.0, static_cast<double>(most));
    const auto count = static_cast<std::size_t>(wanted);
    for (std::size_t k = 1; k < count; ++k)
      instants.push_back(segment.t0 + (segment.t1 - segment.t0) * static_cast<double>(k) / wanted);
    instants.push_back(segment.t1);
  }
  return instants;
}

}  // namespace gouge
