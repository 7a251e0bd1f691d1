#pragma once

#include <string>
#include <vector>

#include "lib/base/units.h"
#include "lib/drawing/drawing.h"

namespace gouge {

inline constexpr Colour kPartGrey{200, 204, 208, 1};
inline constexpr Colour kFixtureGrey{158, 176, 196, 1};
inline constexpr Colour kInk{32, 38, 46, 1};
inline constexpr Colour kSoftInk{104, 112, 122, 1};
inline constexpr Colour kHairline{206, 211, 217, 1};
inline constexpr Colour kAlarm{178, 24, 43, 1};
inline constexpr Colour kCalm{34, 120, 84, 1};

/// Colour of a body of the tool, in every picture the same.
[[nodiscard]] Colour body_colour(int body);

/// Depth to colour: pale yellow just above `low`, through orange and red to dark purple at `high`. Lightness
/// falls steadily, so the order survives a black-and-white print.
struct ColourScale {
  double low_mm = 0, high_mm = 1;
  [[nodiscard]] Colour at(double depth_mm) const;
};

/// From the tolerance to a round number not below the worst depth.
[[nodiscard]] ColourScale make_colour_scale(double tolerance_mm, double worst_mm, LengthUnit unit);

/// A round number (two digits at most) not below `value`. Requires value > 0.
[[nodiscard]] double round_up(double value);
/// 1, 2 or 5 times a power of ten, not above `value`. Requires value > 0.
[[nodiscard]] double round_down(double value);
/// Steps of 1, 2 or 5 times a power of ten that cut [0, high] into about `count` pieces.
[[nodiscard]] double round_step(double high, int count);
/// As many decimals as a step needs: "0.25" for steps of 0.05.
[[nodiscard]] std::string tick_text(double value, double step);

}  // namespace gouge
