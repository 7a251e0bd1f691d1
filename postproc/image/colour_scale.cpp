#include "postproc/image/colour_scale.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "lib/base/number_text.h"
#include "lib/base/tolerance.h"

namespace gouge {
namespace {

constexpr std::array<Colour, 6> kRamp{
    {{255, 226, 110, 1}, {253, 174, 68, 1}, {240, 104, 44, 1}, {203, 30, 58, 1}, {128, 14, 92, 1}, {52, 8, 72, 1}}};

constexpr std::array<Colour, 5> kLeftRamp{
    {{178, 221, 240, 1}, {112, 182, 224, 1}, {52, 132, 196, 1}, {24, 84, 156, 1}, {12, 40, 98, 1}}};

constexpr double kRootRatio = 100;

// Returns a round number with all its decimals.
std::string length_digits(double value) {
  std::string text = fixed_text(value, 9);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text;
}

unsigned char mix(unsigned char a, unsigned char b, double t) {
  return static_cast<unsigned char>(std::lround((1 - t) * a + t * b));
}

// Returns the place of a depth between the ends of the colours.
double share_of(const ColourScale& scale, double depth_mm) {
  const double start = scale.place(scale.low_mm);
  return start < 1 ? std::clamp((scale.place(depth_mm) - start) / (1 - start), 0.0, 1.0) : 1.0;
}

Colour colour_on(std::span<const Colour> ramp, double share) {
  const double step = share * static_cast<double>(ramp.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(step), ramp.size() - 2);
  const double rest = step - static_cast<double>(i);
  return {mix(ramp[i].r, ramp[i + 1].r, rest), mix(ramp[i].g, ramp[i + 1].g, rest), mix(ramp[i].b, ramp[i + 1].b, rest),
          1};
}

}  // namespace

Colour body_colour(int body) {
  static constexpr std::array<Colour, 4> kBodies{
      {{38, 112, 178, 1}, {22, 140, 132, 1}, {126, 96, 168, 1}, {128, 122, 30, 1}}};
  return kBodies[static_cast<std::size_t>(std::clamp(body, 0, 3))];
}

double ColourScale::place(double depth_mm) const {
  const double share = std::clamp(depth_mm / high_mm, 0.0, 1.0);
  return is_root ? std::sqrt(share) : share;
}

double ColourScale::depth_at(double place) const { return high_mm * (is_root ? place * place : place); }

Colour ColourScale::at(double depth_mm) const {
  if (depth_mm < 0) {
    const ColourScale left = left_scale(*this);
    return colour_on(std::span(kLeftRamp), share_of(left, -depth_mm));
  }
  return colour_on(std::span(kRamp), share_of(*this, depth_mm));
}

ColourScale left_scale(const ColourScale& scale) {
  return {scale.left_low_mm, scale.left_high_mm, scale.left_high_mm > kRootRatio * scale.left_low_mm, 0, 0};
}

double round_up(double value) {
  double power = 1;
  while (power > value) power /= 10;
  while (power * 10 <= value) power *= 10;
  for (const double m : {1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0}) {
    if (m * power >= value * (1 - Tolerance::kRounding)) return m * power;
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
  const double raw = std::max(high, Tolerance::kFewRoundings) / std::max(count, 1);
  double power = 1;
  while (power > raw) power /= 10;
  while (power * 10 <= raw) power *= 10;
  for (const double m : {1.0, 2.0, 5.0}) {
    if (m * power >= raw * (1 - Tolerance::kRounding)) return m * power;
  }
  return 10 * power;
}

std::string tick_text(double value, double step) {
  int decimals = 0;
  for (double s = step; s < 0.999 && decimals < 12; s *= 10) ++decimals;
  return fixed_text(value, decimals);
}

ColourScale make_colour_scale(double tolerance_mm, double worst_mm, LengthUnit unit, double headroom) {
  const double scale = mm_per(unit);
  const double worst = std::max({worst_mm * headroom, 2 * tolerance_mm, Tolerance::kWitness_mm}) / scale;
  return {tolerance_mm, round_up(worst) * scale, worst_mm > kRootRatio * tolerance_mm && tolerance_mm > 0, 0, 0};
}

std::vector<Tick> make_ticks(const ColourScale& scale, LengthUnit unit, double gap) {
  const double per = mm_per(unit);
  const double high = scale.high_mm / per;
  if (!scale.is_root) {
    const double step = round_step(high, std::clamp(static_cast<int>(1 / gap), 1, 6));
    std::vector<Tick> ticks;
    for (int k = 0; k * step <= high * (1 + Tolerance::kRounding); ++k)
      ticks.push_back({k * step * per, tick_text(k * step, step)});
    return ticks;
  }
  std::vector<Tick> ticks{{scale.high_mm, length_digits(high)}};
  double last = 1;
  for (double value = round_down(high); value > 0 && ticks.size() < 12; value = round_down(value * 0.99)) {
    const double place = scale.place(value * per);
    if (place < gap) break;
    if (last - place < gap) continue;
    ticks.push_back({value * per, length_digits(value)});
    last = place;
  }
  ticks.push_back({0, "0"});
  std::reverse(ticks.begin(), ticks.end());
  return ticks;
}

}  // namespace gouge
