#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace gouge {

/// Side of the path on which CUTCOM puts the cutter; unknown if it does not state the side.
enum class CutcomSide : std::uint8_t { none, left, right, unknown };

/// Returns the word for the side.
[[nodiscard]] constexpr const char* cutcom_word(CutcomSide side) {
  constexpr std::array<const char*, 4> kWords = {"OFF", "LEFT", "RIGHT", "ON"};
  return kWords[static_cast<std::size_t>(side)];
}

}  // namespace gouge
