#pragma once

#include "lib/check/check_options.h"
#include "lib/check/reason.h"
#include "lib/check/scene.h"
#include "lib/motion/motion.h"
#include "lib/tool/tool_variants.h"

// Rejects inputs outside the range for which the bounds are proved, with the reason. Numbers computed beyond it would
// mean nothing, and a comparison with one that is not a number would read as free.

namespace gouge {

/// Bounds are proved for coordinates up to here (docs/method/certified_sweep.md). A move that reaches farther is not
/// checked, and reported as such.
inline constexpr double kFarthest_mm = 1e5;

/// Finds a point of the motion or of its curve that is beyond kFarthest_mm or not a number. Also finds an axis that is
/// not a unit vector. None where the motion can be checked.
[[nodiscard]] Reason::Kind why_unfit(const Motion& motion);

/// Finds a vertex that is beyond kFarthest_mm or not a number. None where all are fit.
[[nodiscard]] Reason::Kind why_unfit(const Scene& scene);

/// Finds a part of a variant's contour that is beyond kFarthest_mm or not a number. None where all are fit. Cost:
/// O(elements).
[[nodiscard]] Reason::Kind why_unfit(const ToolVariants& tool);

/// Finds a length that is not finite, or a resolution that is not above 0. None where all are fit.
[[nodiscard]] Reason::Kind why_unfit(const CheckOptions& options);

/// Returns whether the point is one that bounds are proven for.
[[nodiscard]] bool is_within_reach(const Vec3& point);

}  // namespace gouge
