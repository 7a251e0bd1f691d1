#include "lib/tilt/tilt_curve.h"

#include "lib/path/bending_sum.h"

namespace gouge {
namespace {

/// Returns the slopes at the knots. Solves the tridiagonal system of a cubic spline by elimination.
std::vector<Tilt> slopes_at(const std::vector<double>& x, const std::vector<Tilt>& y, bool is_first_level,
                            bool is_last_level) {
  const std::size_t n = x.size();
  std::vector<Tilt> slope(n, Tilt::Zero());
  if (n < 2) return slope;
  std::vector<double> diagonal(n, 1), above(n, 0), below(n, 0);
  const auto rise = [&](std::size_t i) -> Tilt { return (y[i + 1] - y[i]) / (x[i + 1] - x[i]); };
  if (!is_first_level) {
    diagonal[0] = 2, above[0] = 1;
    slope[0] = 3 * rise(0);
  }
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double left = x[i] - x[i - 1], right = x[i + 1] - x[i];
    below[i] = right, diagonal[i] = 2 * (left + right), above[i] = left;
    slope[i] = 3 * (right * rise(i - 1) + left * rise(i));
  }
  if (!is_last_level) {
    diagonal[n - 1] = 2, below[n - 1] = 1;
    slope[n - 1] = 3 * rise(n - 2);
  }
  for (std::size_t i = 1; i < n; ++i) {
    const double factor = below[i] / diagonal[i - 1];
    diagonal[i] -= factor * above[i - 1];
    slope[i] -= factor * slope[i - 1];
  }
  for (std::size_t i = n; i-- > 0;) {
    if (i + 1 < n) slope[i] -= above[i] * slope[i + 1];
    slope[i] /= diagonal[i];
  }
  return slope;
}

}  // namespace

TiltSequence curve_through(const std::vector<TiltAnchor>& anchors, const std::vector<double>& arc_lengths_mm,
                           bool is_first_level, bool is_last_level) {
  std::vector<double> x;
  std::vector<Tilt> y;
  for (const TiltAnchor& anchor : anchors) {
    x.push_back(arc_lengths_mm[anchor.position]);
    y.push_back(anchor.tilt);
  }
  const std::vector<Tilt> slope = slopes_at(x, y, is_first_level, is_last_level);
  TiltSequence curve(arc_lengths_mm.size());
  std::size_t k = 0;
  for (std::size_t i = 0; i < arc_lengths_mm.size(); ++i) {
    const double s = arc_lengths_mm[i];
    while (k + 1 < x.size() && s > x[k + 1]) ++k;
    if (s <= x.front() || k + 1 >= x.size()) {
      const std::size_t end = s <= x.front() ? 0 : x.size() - 1;
      curve[i] = y[end] + (s - x[end]) * slope[end];
      continue;
    }
    const double length = x[k + 1] - x[k], u = (s - x[k]) / length, v = 1 - u;
    curve[i] = v * v * (1 + 2 * u) * y[k] + u * u * (1 + 2 * v) * y[k + 1] +
               length * u * v * (v * slope[k] - u * slope[k + 1]);
  }
  for (const TiltAnchor& anchor : anchors) curve[anchor.position] = anchor.tilt;
  return curve;
}

double roughness(const TiltSequence& tilts, const std::vector<double>& arc_lengths_mm) {
  BendingSum<2> bending;
  std::size_t last = 0;
  for (std::size_t i = 1; i < tilts.size(); ++i) {
    const double ds = arc_lengths_mm[i] - arc_lengths_mm[last];
    if (!(ds > 0)) continue;
    bending.add((tilts[i] - tilts[last]) / ds, ds);
    last = i;
  }
  return bending.value();
}

}  // namespace gouge
