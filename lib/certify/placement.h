#pragma once

#include <optional>
#include <string>

#include "lib/base/units.h"
#include "lib/check/check_result.h"
#include "lib/check/scene.h"
#include "lib/path/toolpath.h"

// Evidence for and against a part that lies where the toolpath expects it, in the size that it expects. Each text is
// one sentence without a full stop; nothing where the evidence does not hold.

namespace gouge {

/// Returns text where every part is farther from the box of the path's tips than a tool can reach. The length `tool_mm`
/// is the longest distance from a tip to a point of a tool.
[[nodiscard]] std::optional<std::string> find_gap(const Toolpath& path, const Scene& scene, double tool_mm);

/// Returns text where all parts together are many times smaller than the region that the path cuts. Also where they are
/// many times larger, while most cuts gouge or are buried. The text names each unit of STL files with which the sizes
/// would agree; for larger parts only where there is one such unit. The argument `unit` is the one in which they were
/// read.
[[nodiscard]] std::optional<std::string> find_other_size(const Toolpath& path, const Scene& scene,
                                                         const MoveVerdicts& verdicts, LengthUnit unit);

/// Returns text where no examined cutting position comes near the part. Requires at least 10 positions to judge.
[[nodiscard]] std::optional<std::string> find_apart(const ClosestApproach& closest_approach);

/// Returns text where the path plainly does not fit the part (find_path_fit), with the usual mistake that explains it.
[[nodiscard]] std::optional<std::string> describe_misfit(const Toolpath& path, const PathFit& fit);

/// Returns true where the whole path is wrong, so that correcting its positions is of no use.
[[nodiscard]] bool is_beyond_correction(const PathFit& fit);

}  // namespace gouge
