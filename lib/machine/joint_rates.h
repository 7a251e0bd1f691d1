#pragma once

#include <cstddef>
#include <vector>

#include "lib/machine/machine.h"
#include "lib/path/toolpath.h"

namespace gouge {

/// A feed in which a rotary joint would have to turn faster than its rate permits.
struct RateExcess {
  std::size_t move = 0;
  std::size_t joint = 0;  ///< of Machine::joints
  double needed = 0;      ///< mean rate at the programmed feed, rad per minute
};

/// Returns the feeds that exceed a rate of a rotary joint, the largest ratio first. The control keeps the feed at the tip
/// (tool centre point control). So a move takes the length of the tip's path divided by the feed. Leaves out moves
/// without a feed per minute, moves whose tip rests, and joints without a rate. Requires Toolpath::joints.
[[nodiscard]] std::vector<RateExcess> find_rate_excesses(const Machine& machine, const Toolpath& path);

}  // namespace gouge
