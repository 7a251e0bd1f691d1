#include "lib/stock/widest_radius.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "lib/base/tolerance.h"

namespace gouge {

namespace {

// A face across the axis at the very end of the heights belongs to its other side.
bool is_apart(double low, double high, double lo, double hi) {
  return high <= lo + Tolerance::kRounding_mm || low >= hi - Tolerance::kRounding_mm;
}

double on_segment(const BoundaryElement& e, double lo, double hi) {
  const double low = std::min(e.a.y(), e.b.y()), high = std::max(e.a.y(), e.b.y());
  if (is_apart(low, high, lo, hi)) return -1;
  if (!(high > low)) return std::max(e.a.x(), e.b.x());
  const auto radius_at = [&](double z) {
    const double share = std::clamp((z - e.a.y()) / (e.b.y() - e.a.y()), 0.0, 1.0);
    return e.a.x() + share * (e.b.x() - e.a.x());
  };
  return std::max(radius_at(std::max(lo, low)), radius_at(std::min(hi, high)));
}

// Bounds an arc by its circle within the heights of the arc.
double on_arc(const BoundaryElement& e, double lo, double hi) {
  double low = std::min(e.a.y(), e.b.y()), high = std::max(e.a.y(), e.b.y());
  const double r = e.radius_mm;
  const bool is_lowest_inside = (e.center.y() - r < low) && e.normal.y() < 0 && !e.is_reflex;
  const bool is_highest_inside = (e.center.y() + r > high) && e.normal.y() > 0 && !e.is_reflex;
  if (is_lowest_inside) low = std::min(low, e.center.y() - r);
  if (is_highest_inside) high = std::max(high, e.center.y() + r);
  if (e.is_reflex) {
    low = std::min(low, e.center.y() - r);
    high = std::max(high, e.center.y() + r);
    if (is_apart(low, high, lo, hi)) return -1;
    return e.normal.x() > 0 ? e.center.x() + r : std::max(e.a.x(), e.b.x());
  }
  if (is_apart(low, high, lo, hi)) return -1;
  const double a = std::max(lo, low), b = std::min(hi, high);
  const double nearest = std::clamp(e.center.y(), a, b) - e.center.y();
  return e.center.x() + std::sqrt(std::max(0.0, r * r - nearest * nearest));
}

}  // namespace

double widest_radius_mm(const CompiledTool& tool, double z_lo_mm, double z_hi_mm) {
  double widest = -1;
  for (const BoundaryElement& e : tool.elements) {
    if (e.kind == ElementKind::vertex) continue;
    widest =
        std::max(widest, e.kind == ElementKind::arc ? on_arc(e, z_lo_mm, z_hi_mm) : on_segment(e, z_lo_mm, z_hi_mm));
  }
  return widest;
}

double widest_radius_mm(const CompiledTool& tool, double z_lo_mm, double z_hi_mm, double depth_mm) {
  double least = tool.r_max_mm - depth_mm;
  constexpr double kHalf = std::numbers::sqrt2 / 2;
  // Directions of the half plane: out, up, down, and between.
  constexpr std::array<std::array<double, 2>, 5> kDirections{
      {{1, 0}, {0, 1}, {0, -1}, {kHalf, kHalf}, {kHalf, -kHalf}}};
  for (const auto& [out, up] : kDirections) {
    const double shift = depth_mm * up;
    least = std::min(least, widest_radius_mm(tool, z_lo_mm + shift, z_hi_mm + shift) - depth_mm * out);
  }
  return least;
}

}  // namespace gouge
