#pragma once

#include <optional>
#include <string>

#include "lib/base/units.h"
#include "lib/check/check_result.h"
#include "lib/check/scene.h"
#include "lib/path/toolpath.h"

// Evidence for or against a part that has the position and the size that the toolpath expects. Each text is one
// sentence without a full stop. A function returns nothing if its evidence does not hold.

namespace gouge {

/// Returns a text if every part is farther from the box of the path's tips than a tool can reach. The length `tool_mm`
/// is the longest distance from a tip to a point of a tool.
[[nodiscard]] std::optional<std::string> find_gap(const Toolpath& path, const Scene& scene, double tool_mm);

/// Returns a text if all parts together are many times smaller than the region that the path cuts. It also returns one
/// if they are many times larger while most cuts gouge or are buried. The text names each unit of STL files with which
/// the sizes would agree; for larger parts only if there is exactly one such unit. The argument `unit` is the unit in
/// which the files were read.
[[nodiscard]] std::optional<std::string> find_other_size(const Toolpath& path, const Scene& scene,
                                                         const MoveVerdicts& verdicts, LengthUnit unit);

/// Returns a text if all parts together are many times smaller than the region that the path cuts, or many times larger
/// and of about its size with another unit of STL files. Else returns one if the path would lie in the part with exactly
/// one other unit and the part is not moved. It is no evidence by itself: a small path on a large part is usual. It
/// explains a part that the path does not reach.
[[nodiscard]] std::optional<std::string> explain_by_unit(const Toolpath& path, const Scene& scene, LengthUnit unit,
                                                         bool is_moved);

/// Returns a text if no examined cutting position is near the part. Requires at least 10 positions to judge.
[[nodiscard]] std::optional<std::string> find_apart(const ClosestApproach& closest_approach);

/// Returns a text if the path clearly does not fit the part (find_path_fit), with the usual mistake that explains it.
[[nodiscard]] std::optional<std::string> describe_misfit(const Toolpath& path, const PathFit& fit);

/// Returns true if the whole path is wrong, so that a correction of its positions is useless.
[[nodiscard]] bool is_beyond_correction(const PathFit& fit);

}  // namespace gouge
