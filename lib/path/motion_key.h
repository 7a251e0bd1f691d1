#pragma once

#include <cstddef>
#include <string>

#include "lib/path/toolpath.h"

namespace gouge {

inline constexpr std::size_t kMotionDigits = 32;
/// Digits of each motion in the list `motions` of a result.
inline constexpr std::size_t kListedMotionDigits = 12;

/// Returns 32 hexadecimal digits that identify the motion of a move. They cover its two positions, its curve and kind,
/// and whether it is checked at all. If the motion `is_by_joints`, they also cover the angles of Toolpath::joints. Two moves
/// with the same key, the same tool and the same law sweep exactly the same space, wherever their statements are. The line,
/// the tool and the feed do not enter.
///
/// Angles enter in steps of 1e-10 turns, as their last bits depend on the moves before. Equal whole turns of both ends do not
/// enter.
[[nodiscard]] std::string motion_key(const Toolpath& path, std::size_t move, bool is_by_joints);

}  // namespace gouge
