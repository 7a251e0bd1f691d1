#pragma once

#include <cstddef>
#include <string>

#include "lib/path/toolpath.h"

namespace gouge {

inline constexpr std::size_t kMotionDigits = 32;

/// 32 hexadecimal digits that state which motion a move is: from which position to which, on which curve, of which kind,
/// and whether it is checked at all. Two moves of one key sweep the same space with the same tool, to the last bit,
/// wherever their statements stand; what line, tool or feed they have does not enter.
[[nodiscard]] std::string motion_key(const Toolpath& path, std::size_t move);

}  // namespace gouge
