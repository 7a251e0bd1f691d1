#pragma once

#include <optional>

#include "lib/machine/machine.h"
#include "lib/path/toolpath.h"

namespace gouge {

/// Returns a warning for each rotary joint that exceeds its rate in a feed: the worst feed with its line, and the number of
/// such feeds. None for a law of feeds without tool centre point control, because its feed does
/// not hold at the tip. `feeds`: none if no law is stated. Requires Toolpath::joints.
[[nodiscard]] Diagnostics describe_rate_excesses(const Machine& machine, const std::optional<TurnLaw>& feeds,
                                                 const Toolpath& path);

}  // namespace gouge
