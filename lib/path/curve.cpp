#include "lib/path/curve.h"

#include <algorithm>
#include <cmath>

namespace gouge {
namespace {

constexpr std::size_t kDegree = 3;

// Inserts one more knot at `u` into `control` and `knots` (Boehm 1980).
void insert_knot(std::vector<Vec3>& control, std::vector<double>& knots, double u) {
  const auto above = std::upper_bound(knots.begin(), knots.end(), u);
  const auto span = static_cast<std::size_t>(above - knots.begin()) - 1;
  std::vector<Vec3> next;
  next.reserve(control.size() + 1);
  for (std::size_t i = 0; i <= control.size(); ++i) {
    if (i + kDegree <= span) {
      next.push_back(control[i]);
    } else if (knots[i] >= u) {
      next.push_back(control[i - 1]);  // the other point has weight 0 because the knot already exists
    } else {
      const double share = (u - knots[i]) / (knots[i + kDegree] - knots[i]);
      next.push_back((1 - share) * control[i - 1] + share * control[i]);
    }
  }
  control = std::move(next);
  knots.insert(above, u);
}

bool are_knots(const std::vector<double>& inner) {
  double last = 0;
  std::size_t times = 0;
  for (const double u : inner) {
    if (!(u > 0 && u < 1 && u >= last)) return false;
    times = u > last ? 1 : times + 1;
    if (times > kDegree) return false;
    last = u;
  }
  return true;
}

// Returns the piece between two neighbouring knots. Each piece is cut out by itself, so that the cost stays linear.
SplinePiece cut_out(const std::vector<Vec3>& control, const std::vector<double>& knots, std::size_t span) {
  const double u0 = knots[span], u1 = knots[span + 1];
  std::vector<Vec3> points(control.begin() + static_cast<std::ptrdiff_t>(span - kDegree),
                           control.begin() + static_cast<std::ptrdiff_t>(span + 1));
  std::vector<double> near(knots.begin() + static_cast<std::ptrdiff_t>(span - kDegree),
                           knots.begin() + static_cast<std::ptrdiff_t>(span + kDegree + 2));
  const auto count = [&](double u) {
    return static_cast<std::size_t>(std::upper_bound(near.begin(), near.end(), u) -
                                    std::lower_bound(near.begin(), near.end(), u));
  };
  while (count(u0) < kDegree) insert_knot(points, near, u0);
  while (count(u1) < kDegree) insert_knot(points, near, u1);
  const auto last_u0 = static_cast<std::size_t>(std::upper_bound(near.begin(), near.end(), u0) - near.begin()) - 1;
  SplinePiece piece;
  piece.u0 = u0;
  piece.u1 = u1;
  for (std::size_t k = 0; k <= kDegree; ++k) piece.control[k] = points[last_u0 - kDegree + k];
  return piece;
}

}  // namespace

Vec3 SplinePiece::at(double u) const {
  const double s = (u - u0) / (u1 - u0);
  const double r = 1 - s;
  return r * r * r * control[0] + 3 * r * r * s * control[1] + 3 * r * s * s * control[2] + s * s * s * control[3];
}

double SplinePiece::largest_second_derivative() const {
  const double at_start = (control[0] - 2 * control[1] + control[2]).norm();
  const double at_end = (control[1] - 2 * control[2] + control[3]).norm();
  return 6 * std::max(at_start, at_end) / ((u1 - u0) * (u1 - u0));
}

double SplinePiece::largest_speed() const {
  double longest = 0;
  for (std::size_t k = 0; k < 3; ++k) longest = std::max(longest, (control[k + 1] - control[k]).norm());
  return 3 * longest / (u1 - u0);
}

PathSpline make_spline(const std::vector<Vec3>& control, const std::vector<double>& inner_knots) {
  PathSpline spline;
  if (control.size() != inner_knots.size() + kDegree + 1 || !are_knots(inner_knots)) return spline;
  std::vector<double> knots(kDegree + 1, 0.0);
  knots.insert(knots.end(), inner_knots.begin(), inner_knots.end());
  knots.insert(knots.end(), kDegree + 1, 1.0);
  spline.pieces.reserve(inner_knots.size() + 1);
  for (std::size_t span = kDegree; span < control.size(); ++span) {
    if (knots[span] < knots[span + 1]) spline.pieces.push_back(cut_out(control, knots, span));
  }
  return spline;
}

double arc_length_mm(const PathArc& arc, const Vec3& start, const Vec3& end) {
  const Vec3 from = start - arc.center, to = end - arc.center;
  const double rise = (to - from).dot(arc.axis);
  const double r0 = from.cross(arc.axis).norm(), r1 = to.cross(arc.axis).norm();
  const double around = 0.5 * (r0 + r1) * std::abs(arc.sweep_rad);
  return std::sqrt(around * around + rise * rise);
}

double spline_length_mm(const PathSpline& spline) {
  constexpr int kChords = 16;
  double length = 0;
  for (const SplinePiece& piece : spline.pieces) {
    Vec3 last = piece.control[0];
    for (int k = 1; k <= kChords; ++k) {
      const Vec3 next = piece.at(piece.u0 + (piece.u1 - piece.u0) * k / kChords);
      length += (next - last).norm();
      last = next;
    }
  }
  return length;
}

}  // namespace gouge
