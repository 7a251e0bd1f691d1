#pragma once

#include <optional>
#include <vector>

#include "lib/correct/reworked_path.h"
#include "lib/tilt/plan_tilts.h"

namespace gouge {

/// Gouges of bodies whose strategy is `wanted`, one entry a move. What is buried only leaving it out frees: it counts
/// for that.
[[nodiscard]] std::vector<bool> moves_to(Strategy wanted, const Toolpath& path, const CheckResult& result,
                                         const BodyStrategies& strategies);

/// A path with the positions of a plan: `plan` is of `straight`, or of `path` where there is none, and moves of the
/// result are pieces of the moves of `path`.
[[nodiscard]] ReworkedPath tilt_path(const Toolpath& path, const CheckResult& result,
                                     const std::optional<ReworkedPath>& straight, const TiltPlan& plan,
                                     const std::vector<const ToolVariants*>& tools, const MotionChecker& checker);

}  // namespace gouge
