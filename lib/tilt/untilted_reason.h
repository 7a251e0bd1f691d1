#pragma once

#include <string>

#include "lib/tilt/tilt_lattice.h"
#include "lib/tilt/tilt_run.h"

namespace gouge {

/// Returns the reason why no tilts free a run, for messages.
///
/// It names the worst position of the run: there the missing distance is largest. This distance is the depth at the best
/// of up to 72 tilts within the limits, the largest ones included. It also names a larger tilt that is proved free
/// there, and the joint or limit that prevents it. `space` is that of the search, and `found` its result.
/// Ensures  It is the same at any number of threads.
/// Cost     About one check for each position of the run, and a few hundred more.
[[nodiscard]] std::string untilted_reason(const TiltJob& job, const TiltSpace& space, const LatticeResult& found);

}  // namespace gouge
