#pragma once

#include "toolmodels/cutter.h"

// The outlines of two cutters compared with each other, as when a toolpath and a library describe one tool.

namespace gouge {

/// Returns how far `cutter` reaches out of `other` across the axis at its worst. Both stand on their tips, and are
/// compared up to the lower of both heights. 0 where it stays within, and where one of them makes no profile.
///
/// Units    mm
/// Ensures  Heights that differ by 0.001 mm count as the same, so that a bottom that is flat but for rounding is no
///          reach. Arcs are compared as polygons, to within 1e-5 of their radius.
/// Cost     O(n log n) for outlines of n corners.
[[nodiscard]] double reach_beyond_mm(const Cutter& cutter, const Cutter& other);

}  // namespace gouge
