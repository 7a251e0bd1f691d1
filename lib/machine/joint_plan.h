#pragma once

#include <optional>
#include <vector>

#include "lib/machine/kinematics.h"
#include "lib/path/toolpath.h"

namespace gouge {

/// Returns whether a rotary joint turns back by a whole turn in a move.
[[nodiscard]] bool turns_back(double joint_rad);
/// Returns whether a rotary joint turns by much more than the tool axis in a move.
[[nodiscard]] bool flips(double joint_rad, double axis_rad);
/// Returns whether one of these holds for a rotary joint.
[[nodiscard]] bool breaks_off(const Machine& machine, const RotaryAngles& from, const RotaryAngles& to);

/// Plans the rotary angles at the end of each move with the fewest breaks, and among these plans with the smallest sum of
/// turns. So it is continuous wherever a continuous choice within the limits exists. It knows the whole path, while a choice
/// of the nearest angles may run into a limit that the other solution, or another turn, avoids.
///
/// None: no solution, or none within the limits. At a pole the first joint stays. A plan starts, and
/// turns back, at most four turns beyond the nearest turn.
/// Cost     O(moves). A few microseconds and some 500 bytes for each move.
[[nodiscard]] std::vector<std::optional<RotaryAngles>> plan_joints(const Machine& machine, const Toolpath& toolpath);

}  // namespace gouge
