#pragma once

#include <span>

#include "lib/path/feed.h"
#include "postproc/cldata/language/arguments.h"

// Units of feeds in FEDRAT and CYCLE: IPM, IPR, MMPM, MMPR, FPM, FPR, PERMIN, PERREV, INVERS.

namespace gouge {

/// Reads FEDRAT/..: its one number and the unit beside it, in either order. Without a unit it is per minute, in the
/// file's unit of length. Not understood are another number of numbers, one that is not above 0, two units, and INVERS.
[[nodiscard]] Feed read_feed(std::span<const Argument> arguments, double mm_per_unit);

/// Returns true where FEDRAT only switches how the control gets its feeds (INVERS,AUTO and INVERS,OFF), and where it
/// states no unit.
[[nodiscard]] bool switches_inverse_time(std::span<const Argument> arguments);
[[nodiscard]] bool has_feed_unit(std::span<const Argument> arguments);

/// Reads the feed of the plunge in CYCLE/..: the number after its unit. It is not_stated where there is neither. It is
/// not_understood for a unit without a number, two units, TPI, or FEDRAT without a unit.
[[nodiscard]] Feed read_cycle_feed(std::span<const Argument> arguments, double mm_per_unit);

}  // namespace gouge
