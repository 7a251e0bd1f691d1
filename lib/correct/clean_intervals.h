#pragma once

#include <functional>
#include <vector>

#include "lib/motion/motion.h"

namespace gouge {

/// A time interval of a motion, `first` <= `last` in [0, 1].
struct TimeInterval {
  double first = 0, last = 0;
};

/// Returns whether the motion is clean at every instant between the two, of which `first` is the earlier.
using IsCleanBetween = std::function<bool(double first, double last)>;

/// Finds the time intervals in which a motion is clean, in order and without contact to each other.
///
/// A distance is that of the tip in mm, plus 10 mm for each unit by which the tool axis changes.
/// Ensures  For every interval `is_clean` was true, piece by piece. If the motion is not clean beyond an end of an
///          interval, that end is known to 0.01 mm, or to 2^-14 of the gap if that is longer. An interval that contains
///          neither end of the motion may be missing, but only if it is shorter than a 16th of the motion or than 0.5
///          mm.
/// Cost     At most 63 calls for the intervals and 14 for each of their ends; one call if the whole motion is clean.
[[nodiscard]] std::vector<TimeInterval> find_clean_intervals(const Motion& motion, const IsCleanBetween& is_clean);

}  // namespace gouge
