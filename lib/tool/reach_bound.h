#pragma once

#include <limits>

#include "lib/tool/compiled_tool.h"

// Bounds the reach of a tool into a solid whose surface stays within a given depth of the tool. A saw blade or a
// pointed tip has no point that deep, so the depth alone does not limit its reach. Proof:
// docs/method/inside_outside.md.

namespace gouge {

inline constexpr double kNoReach_mm = std::numeric_limits<double>::infinity();

/// Bounds the largest distance from any point of `form` to the nearest point with two properties. (1) It lies deeper
/// than `depth_mm` in `form`. (2) Points as deep connect it with a point of the axis that is in a region of
/// RegionFinder(bare).at(depth_mm).
///
/// Requires  The depth is above 0, and `form` contains `bare` (it is `bare` or offset from it).
/// Ensures   The result is never less than the true value. If the true value is above `cutoff_mm`, the result exceeds
///           it by a few per cent. If it is well below (by a tenth of the depth), the result is at most `cutoff_mm`. In
///           between, both results are possible. The bound is kNoReach_mm if there is no point with both properties.
/// Cost      About length of the contour / sqrt(radius x cutoff_mm) evaluations: a fraction of a millisecond.
[[nodiscard]] double bound_reach(const CompiledTool& form, const CompiledTool& bare, double depth_mm, double cutoff_mm);

}  // namespace gouge
