#include "postproc/image/colour_scale.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "lib/base/number_text.h"

namespace gouge {
namespace {

constexpr std::array<Colour, 6> kRamp{{{255, 226, 110, 1},
                                       {253, 174, 68, 1},
                                       {240, 104, 44, 1},
                                       {203, 30, 58, 1},
                                       {128, 14, 92, 1},
                                       {52, 8, 72, 1}}};

unsigned char mix(unsigned char a, unsigned char b, double t) {
  return static_cast<unsigned char>(std::lround((1 - t) * a + t * b));
}

}  // namespace

Colour body_colour(int body) {
  static constexpr std::array<Colour, 3> kBodies{{{38, 112, 178, 1}, {22, 140, 132, 1}, {126, 96, 168, 1}}};
  return kBodies[static_cast<std::size_t>(std::clamp(body, 0, 2))];
}

Colour ColourScale::at(double depth_mm) const {
  const double range = high_mm - low_mm;
  const double t = range > 0 ? std::clamp((depth_mm - low_mm) / range, 0.0, 1.0) : 1.0;
  const double place = t * static_cast<double>(kRamp.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(place), kRamp.size() - 2);
  const double rest = place - static_cast<double>(i);
  return {mix(kRamp[i].r, kRamp[i + 1].r, rest), mix(kRamp[i].g, kRamp[i + 1].g, rest),
          mix(kRamp[i].b, kRamp[i + 1].b, rest), 1};
}

double round_up(double value) {
  double power = 1;
  while (power > value) power /= 10;
  while (power * 10 <= value) power *= 10;
  for (const double m : {1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0}) {
    if (m * power >= value * (1 - 1e-9)) return m * power;
  }
  return 10 * power;
}

double round_down(double value) {
  double power = 1;
  while (power > value) power /= 10;
  while (power * 10 <= value) power *= 10;
  for (const double m : {5.0, 2.0}) {
    if (m * power <= value) return m * power;
  }
  return power;
}

double round_step(double high, int count) {
  const double raw = std::max(high, 1e-12) / std::max(count, 1);
  double power = 1;
  while (power > raw) power /= 10;
  while (power * 10 <= raw) power *= 10;
  for (const double m : {1.0, 2.0, 5.0}) {
    if (m * power >= raw * (1 - 1e-9)) return m * power;
  }
  return 10 * power;
}

std::string tick_text(double value, double step) {
  int decimals = 0;
  for (double s = step; s < 0.999 && decimals < 12; s *= 10) ++decimals;
  return fixed_text(value, decimals);
}

ColourScale make_colour_scale(double tolerance_mm, double worst_mm, LengthUnit unit) {
  const double scale = mm_per(unit);
  const double worst = std::max({worst_mm, 2 * tolerance_mm, 1e-6}) / scale;
  return {tolerance_mm, round_up(worst) * scale};
}

}  // namespace gouge
