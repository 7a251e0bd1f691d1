#pragma once

#include <cstdint>

namespace gouge {

/// Which side of the path CUTCOM takes the cutter to; unknown where it says only that it does.
enum class CutcomSide : std::uint8_t { none, left, right, unknown };

/// The word that says it.
[[nodiscard]] constexpr const char* cutcom_word(CutcomSide side) {
  switch (side) {
    case CutcomSide::none:
      return "OFF";
    case CutcomSide::left:
      return "LEFT";
    case CutcomSide::right:
      return "RIGHT";
    case CutcomSide::unknown:
      break;
  }
  return "ON";
}

}  // namespace gouge
