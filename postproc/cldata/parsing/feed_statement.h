#pragma once

#include <span>

#include "lib/path/feed.h"
#include "postproc/cldata/language/arguments.h"

// Units of feeds in FEDRAT and CYCLE: IPM, IPR, MMPM, MMPR, FPM, FPR, PERMIN, PERREV, INVERS.

namespace gouge {

/// Reads FEDRAT/..: one number and its unit, in either order. Without a unit it is per minute, in the file's unit of
/// length. The feed is not_understood for another count of numbers, a number that is not above 0, two units, and
/// INVERS.
[[nodiscard]] Feed read_feed(std::span<const Argument> arguments, double mm_per_unit);

/// Returns whether FEDRAT only switches the mode in which the control gets its feeds (INVERS,AUTO and INVERS,OFF),
/// without a unit.
[[nodiscard]] bool switches_inverse_time(std::span<const Argument> arguments);
[[nodiscard]] bool has_feed_unit(std::span<const Argument> arguments);

/// Reads the feed of the plunge in CYCLE/..: the number after its unit. It is not_stated if there is neither. It is
/// not_understood for a unit without a number, two units, TPI, or FEDRAT without a unit.
[[nodiscard]] Feed read_cycle_feed(std::span<const Argument> arguments, double mm_per_unit);

}  // namespace gouge
