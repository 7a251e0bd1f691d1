#pragma once

#include "lib/check/check_options.h"
#include "lib/check/reason.h"
#include "lib/check/scene.h"
#include "lib/motion/motion.h"
#include "lib/tool/tool_variants.h"

// Rejects inputs outside the range for which the bounds are proved, and states the reason. Numbers computed beyond it
// would be meaningless. A comparison with a value that is not a number would look like "free".

namespace gouge {

/// Maximum coordinate for which bounds are proved (docs/method/certified_sweep.md). A move that reaches farther is
/// reported as not checked.
inline constexpr double kFarthest_mm = 1e5;

/// Finds a point of the motion or of its curve that is beyond kFarthest_mm or not a number, or an axis that is not a
/// unit vector. Returns Kind::none if the motion can be checked.
[[nodiscard]] Reason::Kind why_unfit(const Motion& motion);

/// Returns the same for a tool that stands at this pose.
[[nodiscard]] Reason::Kind why_unfit(const Pose& pose);

/// Finds a vertex that is beyond kFarthest_mm or not a number. Returns Kind::none if there is none.
[[nodiscard]] Reason::Kind why_unfit(const Scene& scene);

/// Finds a part of a variant's contour that is beyond kFarthest_mm or not a number. Returns Kind::none if there is
/// none. Cost: O(elements).
[[nodiscard]] Reason::Kind why_unfit(const ToolVariants& tool);

/// Finds a length that is not finite, or a resolution that is not above 0. Returns Kind::none if there is none.
[[nodiscard]] Reason::Kind why_unfit(const CheckOptions& options);

/// Returns whether bounds are proved for this point.
[[nodiscard]] bool is_within_reach(const Vec3& point);

}  // namespace gouge
