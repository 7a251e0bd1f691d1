#pragma once

#include <string>
#include <vector>

#include "lib/base/units.h"
#include "lib/drawing/drawing.h"

namespace gouge {

inline constexpr Colour kPartGrey{200, 204, 208, 1};
inline constexpr Colour kFixtureGrey{158, 176, 196, 1};
inline constexpr Colour kWhite{255, 255, 255, 1};
inline constexpr Colour kInk{32, 38, 46, 1};
inline constexpr Colour kSoftInk{104, 112, 122, 1};
inline constexpr Colour kHairline{206, 211, 217, 1};
inline constexpr Colour kAlarm{178, 24, 43, 1};
inline constexpr Colour kCalm{34, 120, 84, 1};

/// Returns the colour of a body of the tool, which is the same in every picture.
[[nodiscard]] Colour body_colour(int body);

/// A map from depth to colour: pale yellow just above `low`, through orange and red to dark purple at `high`. Lightness
/// falls steadily, so the order is visible in a black-and-white print.
/// If the worst depth is at least a hundred times the tolerance, lengths on the scale grow with the square root of the
/// depth. Otherwise one holder collision would hide every small gouge.
struct ColourScale {
  double low_mm = 0, high_mm = 1;
  bool is_root = false;
  /// Material left has negative values: pale blue just below -left_low_mm to dark blue at -left_high_mm. 0: there is none.
  double left_low_mm = 0, left_high_mm = 0;
  /// Returns the place on the scale from 0 (depth 0) to 1 (high_mm).
  [[nodiscard]] double place(double depth_mm) const;
  /// Returns the depth at a place on the scale.
  [[nodiscard]] double depth_at(double place) const;
  [[nodiscard]] Colour at(double depth_mm) const;
};

/// A tick of the scale at a round depth. Ticks are in the unit, from 0 up, and at least `gap` apart on the scale.
struct Tick {
  double depth_mm = 0;
  std::string text;
};
[[nodiscard]] std::vector<Tick> make_ticks(const ColourScale& scale, LengthUnit unit, double gap);

/// Returns the scale of material left by itself, from 0 to left_high_mm.
[[nodiscard]] ColourScale left_scale(const ColourScale& scale);

/// Makes the scale from the tolerance to a round number not below the worst depth and its headroom.
[[nodiscard]] ColourScale make_colour_scale(double tolerance_mm, double worst_mm, LengthUnit unit, double headroom = 1);

/// Returns a round number (two digits at most) not below `value`. Requires value > 0.
[[nodiscard]] double round_up(double value);
/// Returns 1, 2 or 5 times a power of ten, not above `value`. Requires value > 0.
[[nodiscard]] double round_down(double value);
/// Returns a step of 1, 2 or 5 times a power of ten that cuts [0, high] into about `count` pieces.
[[nodiscard]] double round_step(double high, int count);
/// Returns a number with the decimals that a step needs: "0.25" for steps of 0.05.
[[nodiscard]] std::string tick_text(double value, double step);

}  // namespace gouge
