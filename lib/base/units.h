#pragma once

#include <array>
#include <numbers>
#include <optional>
#include <string_view>

// Inside the project every length is in millimetres (suffix _mm) and every point in part coordinates, unless its name
// states otherwise. Toolpaths are in millimetres or inches. STL files state no unit; they may have any unit of this
// list.

namespace gouge {

inline constexpr double kDegree_rad = std::numbers::pi / 180;

enum class LengthUnit { mm, inch, um, cm, m };

struct UnitFacts {
  LengthUnit unit = LengthUnit::mm;
  std::string_view option;  ///< name on command lines
  const char* name = "";    ///< name in reports
  double mm = 1;            ///< length in mm; that of the inch by definition
  int decimals = 3;         ///< decimals of lengths for people: about a micrometre
};

/// All units, from the smallest to the largest.
inline constexpr std::array<UnitFacts, 5> kUnits{{{LengthUnit::um, "um", "um", 0.001, 0},
                                                  {LengthUnit::mm, "mm", "mm", 1, 3},
                                                  {LengthUnit::cm, "cm", "cm", 10, 4},
                                                  {LengthUnit::inch, "inch", "in", 25.4, 4},
                                                  {LengthUnit::m, "m", "m", 1000, 6}}};

[[nodiscard]] constexpr const UnitFacts& facts_of(LengthUnit unit) {
  for (const UnitFacts& facts : kUnits) {
    if (facts.unit == unit) return facts;
  }
  return kUnits[1];
}

[[nodiscard]] constexpr double mm_per(LengthUnit unit) { return facts_of(unit).mm; }
[[nodiscard]] constexpr const char* unit_name(LengthUnit unit) { return facts_of(unit).name; }
/// Returns the unit with that name on a command line; none for other words.
[[nodiscard]] constexpr std::optional<LengthUnit> unit_called(std::string_view option) {
  for (const UnitFacts& facts : kUnits) {
    if (facts.option == option) return facts.unit;
  }
  return std::nullopt;
}

}  // namespace gouge
