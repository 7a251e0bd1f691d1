#include "tests/bench/bench_plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gouge::bench {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kSide_mm = 100, kMargin_mm = 4;
constexpr int kPasses = 80, kPerPass = 250;
constexpr std::array<double, 6> kDips_mm = {0.02, 0.04, 0.08, 0.15, 0.3, 0.5};
constexpr std::array<double, 4> kLifts_mm = {5, 10, 20, 40};

double height(double x, double y) {
  return 20 + 3 * std::sin(kTurn * x / 47) * std::cos(kTurn * y / 38 + 0.3) + 0.8 * std::sin(kTurn * (x + y) / 23 + 1);
}

bool is_air_pass(int pass) { return pass % 10 == 7; }
bool is_holder_pass(int pass) { return pass == 9 || pass == 21 || pass == 45 || pass == 63 || pass == 75; }

double dip(int pass, double k) {
  if (pass % 3 != 1 || is_air_pass(pass)) return 0;
  const double first = 20 + (pass * 53) % 180;
  const double peak = kDips_mm[static_cast<std::size_t>(pass / 3) % kDips_mm.size()];
  return peak * window(k, first, first + 44, 4);
}

/// Passes along y, back and forth; between two passes the tool steps aside in contact.
CurvePoint curve(double u) {
  const int pass = std::min(static_cast<int>(u / kPerPass), kPasses - 1);
  const double k = u - pass * kPerPass;
  const double along = std::min(k, kPerPass - 1.0) / (kPerPass - 1.0);
  const double aside = std::max(0.0, k - (kPerPass - 1.0));
  const double reach = kSide_mm - 2 * kMargin_mm;
  const bool is_up = pass % 2 == 0;
  CurvePoint c;
  c.x_mm = kMargin_mm + reach * (pass + aside) / (kPasses - 1.0);
  c.y_mm = kMargin_mm + reach * (is_up ? along : 1 - along);
  c.forward = Vec2::UnitY();
  c.lead_deg = 8 + 6 * std::sin(kTurn * c.y_mm / 61 + 0.11 * c.x_mm);
  c.tilt_deg = 9 * std::sin(kTurn * c.x_mm / 53 + 0.07 * c.y_mm);
  if (is_air_pass(pass)) c.lift_mm = kLifts_mm[static_cast<std::size_t>(pass / 10) % kLifts_mm.size()];
  c.dip_mm = dip(pass, k);
  if (is_holder_pass(pass)) {
    c.holder_share = window(k, 5, 245, 45);
    c.holder_depth_mm = 0.8 - 0.75 * std::cos(kTurn * k / 60);
  }
  return c;
}

}  // namespace

double window(double at, double first, double last, double ramp) {
  const double s = std::clamp(std::min(at - first, last - at) / ramp, 0.0, 1.0);
  return s * s * (3 - 2 * s);
}

PartPlan plan_wavy() {
  const HolderSize holder = {32, 40, 90};
  PartPlan plan;
  plan.name = "wavy";
  plan.height = height;
  plan.mesh = [](std::size_t triangles) { return make_block(height, kSide_mm, triangles); };
  plan.tools = {make_ball(10, holder), make_bull(16, 2, holder), make_taper(4, 5, holder)};
  plan.positions = static_cast<std::size_t>(kPasses) * kPerPass;
  plan.curve = curve;
  return plan;
}

}  // namespace gouge::bench
