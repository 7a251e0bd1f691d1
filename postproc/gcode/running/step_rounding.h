#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

#include "lib/base/units.h"

namespace gouge {

/// Sums of the roundings of incremental words. A control rounds each word to its increment, to the nearest one or towards
/// 0, and the next word counts from there. Absolute words round too, but their roundings do not add up.
class StepRounding {
 public:
  /// Axes 0 to 2 are X, Y and Z. Rotary joint k is axis 3 + k.
  static constexpr std::size_t kFirstRotary = 3;
  /// Increment of rotary words on Haas, Fanuc and Siemens.
  static constexpr double kIncrement_deg = 0.001;
  /// Returns the increment of linear words on these controls, in mm, by the unit of the program.
  [[nodiscard]] static double increment_mm(LengthUnit unit) {
    constexpr double kIncrement_mm = 0.001, kIncrement_inch = 0.0001;
    return unit == LengthUnit::inch ? kIncrement_inch * mm_per(unit) : kIncrement_mm;
  }

  /// Takes an incremental word that runs `times` times. `step` and `increment` are mm or degrees.
  void add(std::size_t axis, double step, double increment, int times = 1) {
    constexpr double kMaxDifference = 1e-4;  // of a whole number of increments, for calculated values
    const double count = step / increment;
    if (std::abs(count - std::round(count)) > kMaxDifference) sums_.at(axis) += increment * times;
  }
  /// Takes an absolute word.
  void end(std::size_t axis) { sums_.at(axis) = 0; }

  /// Returns why the place of an axis is not known; empty: it is.
  [[nodiscard]] std::string why_open(std::size_t axis, std::string_view name) const {
    constexpr double kMaxSum = 0.005;
    if (sums_.at(axis) <= kMaxSum) return {};
    return "incremental values of " + std::string(name) +
           " are no whole increments of the control, and their roundings add up; expected an absolute value, or fewer "
           "decimals";
  }

 private:
  std::array<double, 5> sums_{};
};

}  // namespace gouge
