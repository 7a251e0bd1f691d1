#pragma once

#include "toolmodels/assembly.h"
#include "toolmodels/cutter.h"

// Comparison of the outlines of two tools, for one that both a toolpath and a library describe.

namespace gouge {

/// Returns the maximum distance, across the axis, by which `cutter` reaches out of `other`. Both stand on their tips,
/// and are compared up to the smaller of both heights. Returns 0 if `cutter` stays within `other`, or if one of them
/// has no valid profile.
///
/// Units    mm
/// Ensures  Heights that differ by 0.001 mm count as equal, so that rounding in a flat bottom has no effect. Arcs are
///          compared as polygons, to within 1e-5 of their radius.
/// Cost     O(n log n) for outlines of n corners.
[[nodiscard]] double reach_beyond_mm(const Cutter& cutter, const Cutter& other);

/// Returns the same for two whole tools, between two heights above their tips. A tool reaches out of another one with its
/// whole radius above the top of the other.
[[nodiscard]] double reach_beyond_mm(const ToolAssembly& tool, const ToolAssembly& other, double from_mm, double to_mm);

}  // namespace gouge
