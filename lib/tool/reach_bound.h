#pragma once

#include <limits>

#include "lib/tool/compiled_tool.h"

// Bounds the reach of a tool into a solid whose surface comes nowhere deeper into the tool than a given depth. A saw
// blade or a pointed tip has no point that deep, so depth alone states nothing about it. Proof:
// docs/method/inside_outside.md.

namespace gouge {

inline constexpr double kNoReach_mm = std::numeric_limits<double>::infinity();

/// Bounds the largest distance from any point of `form` to the nearest point with two properties. (1) It lies deeper
/// than `depth_mm` in `form`. (2) It is joined, by points as deep, with a point of the axis that
/// RegionFinder(bare).at(depth_mm) has in a region.
///
/// Requires  The depth is above 0, and `form` holds `bare` (it is `bare` or offset from it).
/// Ensures   Never less than the truth. Where the truth is above `cutoff_mm` the bound exceeds it by few per cent.
///           Where it is well below (by a tenth of the depth) the bound is at most `cutoff_mm`. In between either may
///           be. The bound is kNoReach_mm where there is no such point.
/// Cost      About length of the contour / sqrt(radius x cutoff_mm) evaluations: a fraction of a millisecond.
[[nodiscard]] double bound_reach(const CompiledTool& form, const CompiledTool& bare, double depth_mm, double cutoff_mm);

}  // namespace gouge
