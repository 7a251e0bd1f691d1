#pragma once

#include "lib/certify/motion_checker.h"

namespace gouge {

/// The reason to reject a straight shift of the tool from one pose to another.
enum class ShiftHazard {
  none,
  deeper,      ///< on the way the tool or a head is deeper than at the start
  into_solid,  ///< on the way it is buried
  undecided,   ///< whether it is one of these is not certain
};

/// Requires equal axes.
/// Ensures  none: the depth is at no instant of the shift more than at its start (to twice the resolution, of a head to
///          2 % of it), and the tool is at no instant inside a solid without a surface inside it, as far as the meshes
///          can show: so no shift leads through a wall or on into the material. Proof: docs/method/correction.md.
[[nodiscard]] ShiftHazard check_shift(const Pose& from, const Pose& to, MoveKind kind, const ToolVariants& tool,
                                      const MotionChecker& checker);

}  // namespace gouge
