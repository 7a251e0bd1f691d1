#pragma once

// Inside the project every length is in millimetres (suffix _mm) and every point in part coordinates
// unless its name says otherwise. Files may be in inches; the factor is exact by definition.

namespace gouge {

enum class LengthUnit { mm, inch };

[[nodiscard]] constexpr double mm_per(LengthUnit unit) {
  return unit == LengthUnit::inch ? 25.4 : 1.0;
}
[[nodiscard]] constexpr const char* unit_name(LengthUnit unit) {
  return unit == LengthUnit::inch ? "in" : "mm";
}

}  // namespace gouge
