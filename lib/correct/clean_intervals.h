#pragma once

#include <functional>
#include <vector>

#include "lib/motion/motion.h"

namespace gouge {

/// A time interval of a motion, `first` <= `last` in [0, 1].
struct TimeInterval {
  double first = 0, last = 0;
};

/// Returns whether the motion is clean at every instant between two, the earlier one first.
using IsCleanBetween = std::function<bool(double first, double last)>;

/// Finds the time intervals in which a motion is clean, in order and apart from each other.
///
/// Distances are those of the tip, in mm, and 10 mm for each unit by which the tool axis changes.
/// Ensures  For every interval `is_clean` was true, piece by piece. Where the motion is not clean beyond an end of an
///          interval, that end is known to 0.01 mm. Where 2^-14 of the gap is longer, it is known to that. An interval
///          that holds neither end of the motion may be missing. That occurs only where no 16th of the motion fits into
///          it, or not 0.5 mm.
/// Cost     At most 63 calls for the intervals and 14 for each of their ends; one where the whole motion is clean.
[[nodiscard]] std::vector<TimeInterval> find_clean_intervals(const Motion& motion, const IsCleanBetween& is_clean);

}  // namespace gouge
