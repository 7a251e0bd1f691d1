#include "tests/laws/expander_curves.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace gouge::laws {
namespace {

constexpr double kRadiusOff_mm = 0.02;
constexpr double kSamePoint_mm = 1e-6;
constexpr double kNearlySame_mm = 0.002;
constexpr double kTurn = 2 * std::numbers::pi;

Vec3 across(const Vec3& v, const Vec3& normal) { return v - v.dot(normal) * normal; }

}  // namespace

CurvePoints turned_points(const Vec3& center, const Vec3& normal, double sweep_rad, const Vec3& start,
                          const Vec3& end) {
  const Vec3 from = start - center, to = end - center;
  const Vec3 u = across(from, normal).normalized(), v = normal.cross(u);
  const double r0 = across(from, normal).norm(), r1 = across(to, normal).norm();
  const double h0 = from.dot(normal), h1 = to.dot(normal);
  CurvePoints points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double t = 0.25 * static_cast<double>(i + 1), angle = t * sweep_rad;
    points[i] =
        center + (r0 + t * (r1 - r0)) * (std::cos(angle) * u + std::sin(angle) * v) + (h0 + t * (h1 - h0)) * normal;
  }
  return points;
}

std::optional<CurvePoints> arc_points(const StatedArc& arc, const Vec3& start, const Vec3& end,
                                      std::string& uncertainty) {
  Vec3 normal = arc.normal;
  const Vec3 u = across(start - arc.center, normal), v = across(end - arc.center, normal);
  const double r = arc.radius.value_or(u.norm());
  if (std::abs(u.norm() - v.norm()) > kRadiusOff_mm || std::abs(u.norm() - r) > kRadiusOff_mm || u.norm() <= 0) {
    uncertainty = "start, end and radius of the arc differ";
    return std::nullopt;
  }
  double angle = std::atan2(normal.dot(u.cross(v)), u.dot(v));
  const double gap = (u - v).norm();
  if (arc.is_short_way) {
    if (angle < 0) {
      angle = -angle;
      normal = -normal;
    }
    if (gap < kNearlySame_mm || angle > 0.99 * std::numbers::pi) {
      uncertainty = "nothing says which way the arc runs";
      return std::nullopt;
    }
    return turned_points(arc.center, normal, angle, start, end);
  }
  if (gap < kSamePoint_mm)
    angle = kTurn;
  else if (angle <= 0)
    angle += kTurn;
  if (gap >= kSamePoint_mm && gap < kNearlySame_mm && !arc.sweep_deg) {
    uncertainty = "the arc ends next to its start";
    return std::nullopt;
  }
  angle += kTurn * (arc.turns - 1);
  if (arc.sweep_deg) {
    const double stated = *arc.sweep_deg * std::numbers::pi / 180;
    const double turns = std::round((stated - angle) / kTurn);
    if (std::abs(stated - angle - turns * kTurn) * r > 0.05 || stated <= 0) {
      uncertainty = "the stated angle does not lead to the end of the arc";
      return std::nullopt;
    }
    angle = stated;
  }
  return turned_points(arc.center, normal, angle, start, end);
}

CurvePoints spline_points(const std::vector<Vec3>& control, const std::vector<double>& inner_knots) {
  std::vector<double> knots(4, 0.0);
  knots.insert(knots.end(), inner_knots.begin(), inner_knots.end());
  knots.insert(knots.end(), 4, 1.0);
  CurvePoints points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double u = 0.25 * static_cast<double>(i + 1);
    std::size_t span = 3;
    while (span + 1 < control.size() && u >= knots[span + 1]) ++span;
    std::array<Vec3, 4> d;
    for (std::size_t j = 0; j < 4; ++j) d[j] = control[span - 3 + j];
    for (std::size_t level = 1; level < 4; ++level) {
      for (std::size_t j = 3; j >= level; --j) {
        const double low = knots[span - 3 + j], high = knots[span + 1 + j - level];
        const double a = high > low ? (u - low) / (high - low) : 0;
        d[j] = (1 - a) * d[j - 1] + a * d[j];
      }
    }
    points[i] = d[3];
  }
  return points;
}

}  // namespace gouge::laws
