#pragma once

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "lib/geom/vec.h"

// Numbers that are only known to lie between two doubles, by CGAL. A result computed from them contains the true value
// of the formula, with any rounding by the processor. Every function that uses them runs under RoundsUpward.

namespace gouge {

using Bounds = CGAL::Interval_nt<false>;
using RoundsUpward = CGAL::Protect_FPU_rounding<true>;

/// A point or vector whose coordinates are intervals.
struct Bounds3 {
  std::array<Bounds, 3> v{Bounds(0), Bounds(0), Bounds(0)};

  Bounds3() = default;
  Bounds3(const Bounds& x, const Bounds& y, const Bounds& z) : v{x, y, z} {}
  explicit Bounds3(const Vec3& p) : v{Bounds(p.x()), Bounds(p.y()), Bounds(p.z())} {}

  [[nodiscard]] const Bounds& operator[](std::size_t k) const { return v[k]; }
  [[nodiscard]] Vec3 middle() const {
    const auto mid = [](const Bounds& i) { return 0.5 * (i.inf() + i.sup()); };
    return {mid(v[0]), mid(v[1]), mid(v[2])};
  }
};

inline Bounds3 operator+(const Bounds3& a, const Bounds3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Bounds3 operator-(const Bounds3& a, const Bounds3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Bounds3 operator*(const Bounds& s, const Bounds3& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline Bounds dot(const Bounds3& a, const Bounds3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Bounds3 cross(const Bounds3& a, const Bounds3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// Returns bounds of the square root. CGAL's own function switches the rounding mode for the lower end and back, which
/// takes longer than the roots. Rounded upward, the root of x is at most sqrt(x) (1 + e) with e = 2^-52, and sqrt(x) (1
/// + e) (1 - e) < sqrt(x). Values below zero, which come from rounding, count as zero.
inline Bounds square_root(const Bounds& x) {
  constexpr double e = 0x1p-52;
  const double lower = std::sqrt(std::max(0.0, x.inf())), upper = std::sqrt(std::max(0.0, x.sup()));
  return {-(lower * e - lower), upper};
}
inline Bounds length(const Bounds3& a) {
  return square_root(CGAL::square(a[0]) + CGAL::square(a[1]) + CGAL::square(a[2]));
}
inline Bounds3 direction_of(const Bounds3& a) {
  const Bounds n = length(a);
  return {a[0] / n, a[1] / n, a[2] / n};
}

/// Returns the smallest interval that contains both.
inline Bounds hull(const Bounds& a, const Bounds& b) {
  return {std::min(a.inf(), b.inf()), std::max(a.sup(), b.sup())};
}
inline Bounds3 hull(const Bounds3& a, const Bounds3& b) {
  return {hull(a[0], b[0]), hull(a[1], b[1]), hull(a[2], b[2])};
}
/// Returns the interval of all values within `by` of `a`.
inline Bounds widened(const Bounds& a, double by) { return a + Bounds(-by, by); }
inline Bounds3 widened(const Bounds3& a, double by) {
  return {widened(a[0], by), widened(a[1], by), widened(a[2], by)};
}

/// Sine and cosine of angles up to 8 by the Taylor polynomial. The next term of the series bounds the remainder.
struct SineCosine {
  Bounds sine, cosine;
};
[[nodiscard]] SineCosine sine_cosine(const Bounds& angle);

}  // namespace gouge
