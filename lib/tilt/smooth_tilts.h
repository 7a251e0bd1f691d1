#pragma once

#include "lib/tilt/tilt_lattice.h"

namespace gouge {

/// Finds a smooth sequence of tilts near a proved one, as proved as that.
///
/// First each tilt of the sequence is drawn in towards none as far as all on the way there is free, to 0.01 degrees.
/// Then the smoothest curve is sought that needs no more than that. It begins untilted. Where it is not free, or tilted
/// further than any of the drawn-in tilts, the drawn-in tilt of the worst position becomes an anchor. Then the
/// smoothest curve through all anchors is tried. Where that position was an anchor already, the proved tilt is taken.
/// At the end anchors that are not needed are released. Every position and every motion of the result is certified.
///
/// Requires a sequence as find_tilts gives it.
/// Ensures  Free by TiltSpace, everywhere; the same at any number of threads.
/// Cost     Some ten times the checks of all positions.
[[nodiscard]] TiltSequence smooth_tilts(const TiltSpace& space, const TiltSequence& proven, unsigned threads);

}  // namespace gouge
