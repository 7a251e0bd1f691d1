#pragma once

#include <cstddef>
#include <vector>

#include "lib/motion/motion.h"

namespace gouge {

/// Returns instants in (0, 1], ascending, the last 1: on straight lines from 0 over the tips at these instants the tip is
/// nowhere farther off than `error_mm`, unless a segment needs more than `most` lines. Requires error_mm > 0, most > 0.
[[nodiscard]] std::vector<double> chord_instants(const Motion& motion, double error_mm, std::size_t most);

}  // namespace gouge
