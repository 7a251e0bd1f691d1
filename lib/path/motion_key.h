#pragma once

#include <cstddef>
#include <string>

#include "lib/path/toolpath.h"

namespace gouge {

inline constexpr std::size_t kMotionDigits = 32;
/// Digits of each motion in the list `motions` of a result.
inline constexpr std::size_t kListedMotionDigits = 12;

/// Returns 32 hexadecimal digits that identify the motion of a move. They cover its two positions, its curve and kind,
/// and whether it is checked at all. Two moves with the same key and the same tool sweep exactly the same space,
/// wherever their statements are. The line, the tool and the feed do not enter.
[[nodiscard]] std::string motion_key(const Toolpath& path, std::size_t move);

}  // namespace gouge
