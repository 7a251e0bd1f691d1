#pragma once

#include <vector>

#include "lib/tilt/tilt_space.h"

namespace gouge {

/// Turns the first direction of tilt of every position into the feed direction, for lead and side tilts.
///
/// A motion along the tool axis has no feed direction. Positions on such motions take that of the pass beside them. If
/// the passes before and after go different ways, the position farthest from all collisions stays as programmed, and
/// each side takes the direction of its own pass. So does a position between two such passes.
/// Requires that the first directions turn only as much as the axis turns.
void follow_feed(std::vector<TiltPosition>& positions);

}  // namespace gouge
