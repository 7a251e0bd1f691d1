#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "tests/bench/bench_plan.h"

namespace gouge::bench {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kRadius_mm = 50, kOuter_mm = 46, kInner_mm = 6, kPitch_mm = 1;
constexpr std::size_t kPositions = 20000;
constexpr std::array<double, 5> kDips_mm = {0.03, 0.25, 0.06, 0.5, 0.12};
constexpr std::array<double, 3> kLifts_mm = {6, 25, 12};

/// A hub with seven swept blades that rise out of it, and three round pockets between them.
double height(double x, double y) {
  const double r = std::sqrt(x * x + y * y);
  const double turn = std::atan2(y, x);
  const double swept = turn + 0.018 * r;
  const double across = std::sin(3.5 * swept) * r / 16;
  const double rise = std::clamp((r - 10) / 14, 0.0, 1.0);
  double z = 34 - 0.006 * r * r + 3 * rise * rise * (3 - 2 * rise) * std::exp(-across * across);
  for (int k = 0; k < 3; ++k) {
    const double at = kTurn * (k + 0.37) / 3;
    const double dx = x - 31 * std::cos(at), dy = y - 31 * std::sin(at);
    z -= 2 / (1 + std::exp((std::sqrt(dx * dx + dy * dy + 0.01) - 7) / 1.2));
  }
  return z;
}

CurvePoint curve(double u) {
  const double share = u / static_cast<double>(kPositions);
  const double r2 = kOuter_mm * kOuter_mm - (kOuter_mm * kOuter_mm - kInner_mm * kInner_mm) * share;
  const double r = std::sqrt(r2);
  const double turn = kTurn * (kOuter_mm - r) / kPitch_mm;
  CurvePoint c;
  c.x_mm = r * std::cos(turn);
  c.y_mm = r * std::sin(turn);
  c.forward = Vec2(-std::sin(turn), std::cos(turn));
  c.lead_deg = 11 + 7 * std::sin(3 * turn + 0.2 * r);
  c.tilt_deg = 10 * std::sin(2 * turn + 1) * std::cos(0.15 * r);
  const auto segment = static_cast<std::size_t>(u / 2000);
  const double in_stretch = u - 2000 * static_cast<double>(segment);
  if (in_stretch > 1750 && in_stretch < 1950) c.lift_mm = kLifts_mm[segment % kLifts_mm.size()];
  const auto dive = static_cast<std::size_t>(u / 800);
  c.dip_mm =
      c.lift_mm > 0 ? 0 : kDips_mm[dive % kDips_mm.size()] * window(u - 800 * static_cast<double>(dive), 100, 146, 5);
  if (c.lift_mm <= 0) {
    c.holder_share = std::max(window(u, 3150, 3380, 45), window(u, 9150, 9380, 45));
    c.holder_share = std::max(c.holder_share, window(u, 15200, 15430, 45));
    c.holder_depth_mm = 1.05 + 0.95 * std::sin(kTurn * u / 80);
  }
  return c;
}

}  // namespace

PartPlan plan_unseen() {
  const HolderSize holder = {40, 35, 95};
  PartPlan plan;
  plan.name = "unseen";
  plan.height = height;
  plan.mesh = [](std::size_t triangles) { return make_disc(height, kRadius_mm, triangles); };
  plan.tools = {make_ball(6, holder), make_bull(10, 1, holder), make_taper(3, 3, holder)};
  plan.positions = kPositions;
  plan.curve = curve;
  return plan;
}

}  // namespace gouge::bench
