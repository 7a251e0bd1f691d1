#pragma once

#include "lib/check/check_options.h"
#include "lib/check/reason.h"
#include "lib/check/scene.h"
#include "lib/motion/motion.h"
#include "lib/tool/tool_variants.h"

// Rejects inputs outside the range for which the bounds are proved, with the reason. Numbers computed beyond it would
// mean nothing, and a comparison with one that is not a number would read as free.

namespace gouge {

/// Bounds are proven for coordinates up to here (docs/method/certified_sweep.md). What reaches farther is not
/// checked, and reported as such.
inline constexpr double kFarthest_mm = 1e5;

/// A point of the motion or of its curve beyond kFarthest_mm or that is no number, or an axis that is no unit
/// vector. None where the motion can be checked.
[[nodiscard]] Reason::Kind why_unfit(const Motion& motion);

/// A vertex beyond kFarthest_mm or that is no number. None where there is none.
[[nodiscard]] Reason::Kind why_unfit(const Scene& scene);

/// A part of a variant's contour beyond kFarthest_mm or that is no number. None where there is none. Cost: O(elements).
[[nodiscard]] Reason::Kind why_unfit(const ToolVariants& tool);

/// A length that is not finite, or a resolution that is not above 0. None where there is none.
[[nodiscard]] Reason::Kind why_unfit(const CheckOptions& options);

/// Returns whether the point is one that bounds are proven for.
[[nodiscard]] bool is_within_reach(const Vec3& point);

}  // namespace gouge
