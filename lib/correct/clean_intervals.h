#pragma once

#include <functional>
#include <vector>

#include "lib/motion/motion.h"

namespace gouge {

/// A time interval of a motion, `first` <= `last` in [0, 1].
struct TimeInterval {
  double first = 0, last = 0;
};

/// A test of whether the motion is clean at every instant from `first` to `last`.
using IsCleanBetween = std::function<bool(double first, double last)>;

/// Finds the time intervals in which a motion is clean, in order and without contact to each other.
///
/// A distance is that of the tip in mm, plus 10 mm for each unit by which the tool axis changes.
/// Ensures  For every interval `is_clean` was true, piece by piece. An end of an interval beyond which the motion is
///          not clean is known to 0.01 mm, or to 2^-14 of a longer gap. An interval with neither end of the motion may
///          be missing. It is then shorter than a 16th of the motion or than 0.5 mm.
/// Cost     At most 63 calls for the intervals and 14 for each of their ends; one call if the whole motion is clean.
[[nodiscard]] std::vector<TimeInterval> find_clean_intervals(const Motion& motion, const IsCleanBetween& is_clean);

}  // namespace gouge
