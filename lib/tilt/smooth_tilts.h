#pragma once

#include "lib/tilt/tilt_lattice.h"

namespace gouge {

/// Finds a smooth sequence of tilts near a proved one. The result is proved to the same extent.
///
/// First each tilt of the sequence is reduced towards zero, as long as all tilts on the way are free, to 0.01 degrees.
/// Then the smoothest curve is sought that needs no more tilt than that. It begins without tilt. If it is not free at a
/// position, or tilts further than all reduced tilts, the worst position becomes an anchor with its reduced tilt. Then
/// the smoothest curve through all anchors is tried. If that position already was an anchor, its tilt grows towards the
/// proved tilt. At the end unnecessary anchors are removed. Every position and every motion of the result is certified.
///
/// Requires a sequence that find_tilts returned.
/// Ensures  The result is free everywhere, as defined by TiltSpace, and the same at any number of threads.
/// Cost     About ten times the checks of all positions.
[[nodiscard]] TiltSequence smooth_tilts(const TiltSpace& space, const TiltSequence& proven, unsigned threads);

}  // namespace gouge
