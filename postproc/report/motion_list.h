#pragma once

#include <cstddef>

namespace gouge {

/// Form of `motions` in a report's JSON: so many of the digits of each motion_key, so many moves in one text.
inline constexpr std::size_t kListedDigits = 12, kMotionsOfText = 1000;

}  // namespace gouge
