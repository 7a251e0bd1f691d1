#pragma once

#include "lib/certify/motion_checker.h"

namespace gouge {

/// The reason to reject a straight shift of the tool from one pose to another.
enum class ShiftHazard {
  none,
  deeper,      ///< during the shift the tool or a head is deeper than at the start
  into_solid,  ///< during the shift the tool or a head is buried
  undecided,   ///< it is not certain whether one of these holds
};

/// Returns the reason to reject a straight shift, or none. Requires equal axes.
/// Ensures  With `none` the depth at each instant of the shift is at most that at its start. This holds to twice the
///          resolution, and for a head to 2 % of its depth. At no instant is the tool inside a solid without a surface
///          inside the tool, as far as the meshes can show. So no shift leads through a wall or farther into the
///          material. Proof: docs/method/correction.md.
[[nodiscard]] ShiftHazard check_shift(const Pose& from, const Pose& to, MoveKind kind, const ToolVariants& tool,
                                      const MotionChecker& checker);

}  // namespace gouge
