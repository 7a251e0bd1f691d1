#pragma once

#include <string>
#include <vector>

#include "lib/certify/motion_checker.h"
#include "lib/correct/correct_path.h"

// Drilled holes that are too deep: their positions move along the tool axis, and all heights of the cycle with them.

namespace gouge {

/// The moves [first, last) of one hole and where it goes.
struct HolePlan {
  std::size_t first = 0, last = 0;
  Vec3 shift_mm = Vec3::Zero();  ///< along the tool axis, away from the part
  double depth_before_mm = 0, depth_after_mm = 0;
};

/// Returns the end of the hole that begins at `first`: its moves are neighbouring cycle steps of one statement.
[[nodiscard]] std::size_t end_of_hole(const Toolpath& path, std::size_t first);

/// A hole [first, last) of which a step gouges and that stays where it is, and why.
struct HoleLeft {
  std::size_t first = 0, last = 0;
  std::string reason;
};

struct HolePlans {
  std::vector<HolePlan> lifted;
  std::vector<HoleLeft> left;  ///< where more is known than that no lift frees it
};

/// Plans the holes of which a step gouges and which the file can write elsewhere. Each plan is the least lift for which
/// the steps that gouge, shifted with it, are clean, and keeps the law of a shift. The written file shows how the path
/// to the hole and from it runs then.
///
/// Ensures  No hole is lifted out of the part. A lift is at most a quarter of the depth below the surface that
///          surrounds the drill (hole_depth.h), and a quarter of the diameter. Any other hole stays.
[[nodiscard]] HolePlans plan_holes(const Toolpath& path, const CheckResult& result,
                                   const std::vector<const ToolVariants*>& tools, const MotionChecker& checker,
                                   const CorrectOptions& correct);

}  // namespace gouge
