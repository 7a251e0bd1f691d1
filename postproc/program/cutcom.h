#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace gouge {

/// Side of the path to which CUTCOM takes the cutter; unknown where it states only that it does.
enum class CutcomSide : std::uint8_t { none, left, right, unknown };

/// Returns the word that states it.
[[nodiscard]] constexpr const char* cutcom_word(CutcomSide side) {
  constexpr std::array<const char*, 4> kWords = {"OFF", "LEFT", "RIGHT", "ON"};
  return kWords[static_cast<std::size_t>(side)];
}

}  // namespace gouge
