#pragma once

#include <functional>
#include <optional>
#include <string>

#include "lib/base/units.h"
#include "lib/check/check_result.h"
#include "lib/check/scene.h"
#include "lib/hierarchy/block_tree.h"
#include "lib/path/toolpath.h"

// Evidence for or against a part that has the position and the size that the toolpath expects. Each text is one
// sentence without a full stop. A function returns nothing if its evidence does not hold.

namespace gouge {

/// Returns the distance from the part to the nearest of some cutting positions, if the part were `times` as large. Looks at
/// all of them, or at 450 that are evenly spread. Nothing: there is no part or no cutting position.
/// Cost     A search in the tree for each of these positions.
[[nodiscard]] std::optional<double> nearest_tip_mm(const Toolpath& path, const BlockTree& part, double times = 1);

/// Returns a text if every part is farther from the box of the path's tips than a tool can reach. The length `tool_mm`
/// is the longest distance from a tip to a point of a tool. `part` is the tree of all parts.
[[nodiscard]] std::optional<std::string> find_gap(const Toolpath& path, const Scene& scene, const BlockTree& part,
                                                  double tool_mm);

/// Returns a text if all parts together are many times smaller than the region that the path cuts. It also returns one
/// if they are many times larger while most cuts gouge or are buried. The text names each unit of STL files with which
/// the sizes would agree; for larger parts only if there is exactly one such unit. The argument `unit` is the unit in
/// which the files were read.
[[nodiscard]] std::optional<std::string> find_other_size(const Toolpath& path, const Scene& scene,
                                                         const MoveVerdicts& verdicts, LengthUnit unit);

/// Returns a text if all parts together are many times smaller than the region that the path cuts, or many times larger
/// and of about its size with another unit of STL files. Else returns one if the path would lie in the part with exactly
/// one other unit and the part is not moved. It is no evidence by itself: a small path on a large part is usual. It
/// explains a part that the path does not reach. A unit is named only if `fits` returns true for the size that the part
/// would have, as a multiple of its size.
[[nodiscard]] std::optional<std::string> explain_by_unit(const Toolpath& path, const Scene& scene, LengthUnit unit,
                                                         bool is_moved, const std::function<bool(double times)>& fits);

/// Returns a text if no examined cutting position is near the part. Requires at least 10 positions to judge.
[[nodiscard]] std::optional<std::string> find_apart(const ClosestApproach& closest_approach);

/// Returns a text if the path clearly does not fit the part (find_path_fit), with the usual mistake that explains it.
[[nodiscard]] std::optional<std::string> describe_misfit(const Toolpath& path, const PathFit& fit);

/// Returns true if the whole path is wrong, so that a correction of its positions is useless.
[[nodiscard]] bool is_beyond_correction(const PathFit& fit);

}  // namespace gouge
