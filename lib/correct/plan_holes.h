#pragma once

#include <string>
#include <vector>

#include "lib/certify/motion_checker.h"
#include "lib/correct/correct_path.h"

// Corrects drilled holes that are too deep: their positions move along the tool axis, together with all heights of the
// cycle.

namespace gouge {

/// The moves [first, last) of one hole, and its shift.
struct HolePlan {
  std::size_t first = 0, last = 0;
  Vec3 shift_mm = Vec3::Zero();  ///< shift along the tool axis, away from the part
  double depth_before_mm = 0, depth_after_mm = 0;
};

/// Returns the end of the hole that begins at `first`. Its moves are neighbouring cycle steps of one statement.
[[nodiscard]] std::size_t end_of_hole(const Toolpath& path, std::size_t first);

/// A hole [first, last) with a gouging step that stays where it is, and the reason.
struct HoleLeft {
  std::size_t first = 0, last = 0;
  std::string reason;
};

struct HolePlans {
  std::vector<HolePlan> lifted;
  std::vector<HoleLeft> left;  ///< holes for which more is known than that no lift frees them
};

/// Plans the holes with a gouging step that the file can write at another place. Each plan is the smallest lift with
/// which the gouging steps are clean and the rules of a shift hold. The check of the written file shows whether the
/// paths to the hole and away from it are clean then.
///
/// Ensures  No hole is lifted out of the part. A lift is at most a quarter of the depth below the surface that
///          surrounds the drill (depth_below_surface_mm), and a quarter of the diameter. Any other hole stays.
[[nodiscard]] HolePlans plan_holes(const Toolpath& path, const CheckResult& result,
                                   const std::vector<const ToolVariants*>& tools, const MotionChecker& checker,
                                   const CorrectOptions& correct);

}  // namespace gouge
