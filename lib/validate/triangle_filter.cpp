#include "lib/validate/triangle_filter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace gouge::detail {
namespace {

// Error bounds relative to the sum of the absolute products, in units of u = 2^-53. They are 4, 8 and 5 u for errors of
// 3 + 16 u, 7 + 56 u and 4 + 16 u; the difference covers the rounding of the bound itself. The absolute bound covers
// products below the smallest normal numbers.
constexpr double kUnit = 1.1102230246251565e-16;
constexpr double kArea = 4 * kUnit, kVolume = 8 * kUnit, kDot = 5 * kUnit, kUnderflow = 1e-200;

int sign_of(double value, double error) { return value > error ? 1 : value < -error ? -1 : 0; }

/// The cross product of two vectors (differences of points), and the sums of the absolute values of its products.
struct Cross {
  Cross(const Vec3& u, const Vec3& v) {
    for (Eigen::Index k = 0; k < 3; ++k) {
      const Eigen::Index i = (k + 1) % 3, j = (k + 2) % 3;
      const double plus = u[i] * v[j], minus = u[j] * v[i];
      value[k] = plus - minus;
      magnitude[k] = std::abs(plus) + std::abs(minus);
    }
  }

  /// Returns the side of the line along u on which v lies, seen along axis k; 0: unknown.
  [[nodiscard]] int side(Eigen::Index k) const { return sign_of(value[k], kArea * magnitude[k] + kUnderflow); }

  /// Returns the side of the plane along u and v on which the vector w lies; 0: unknown.
  [[nodiscard]] int side_of(const Vec3& w) const {
    return sign_of(value.dot(w), kVolume * magnitude.dot(w.cwiseAbs()) + kUnderflow);
  }

  Vec3 value, magnitude;
};

/// Returns whether the angle between vector w and direction n is certainly acute.
bool is_surely_along(const Vec3& n, const Vec3& w) {
  return n.dot(w) > kDot * n.cwiseAbs().dot(w.cwiseAbs()) + kUnderflow;
}

/// Tests a plane through the common corner that separates t from u. The vectors a, b and c, d lead from that corner to
/// the other corners of t and of u.
bool has_plane_across_corner(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 n = a / a.norm() + b / b.norm() - c / c.norm() - d / d.norm();
  return is_surely_along(n, a) && is_surely_along(n, b) && is_surely_along(-n, c) && is_surely_along(-n, d);
}

/// Tests a plane through one side at the common corner and along a coordinate axis. It must separate the rest of that
/// side's triangle from the other triangle. `third` is the cross product of the two sides of the side's own triangle.
/// `one` and `other` are those with the sides of the other triangle. `turned` is 1 if the order of one product is
/// reversed.
bool has_plane_through_side(const Cross& third, const Cross& one, const Cross& other, int turned) {
  for (Eigen::Index k = 0; k < 3; ++k) {
    const int beyond = turned * third.side(k);
    if (beyond != 0 && one.side(k) == beyond && other.side(k) == beyond) return true;
  }
  return false;
}

/// Tests whether u is strictly on one side of the plane of t. Otherwise tests planes through a side of t and along an
/// axis. Then u must be strictly on the other side than t.
bool is_apart_by_planes_of(const std::array<Vec3, 3>& t, const std::array<Vec3, 3>& u) {
  const Cross normal(t[1] - t[0], t[2] - t[0]);
  const int side = normal.side_of(u[0] - t[0]);
  if (side != 0 && normal.side_of(u[1] - t[0]) == side && normal.side_of(u[2] - t[0]) == side) return true;
  for (std::size_t s = 0; s < 3; ++s) {
    const Vec3 &from = t[s], &to = t[(s + 1) % 3];
    const Cross first(to - from, u[0] - from), second(to - from, u[1] - from), third(to - from, u[2] - from);
    for (Eigen::Index k = 0; k < 3; ++k) {
      const int own = normal.side(k);  // side of the third corner, for any side of t
      if (own != 0 && first.side(k) == -own && second.side(k) == -own && third.side(k) == -own) return true;
    }
  }
  return false;
}

}  // namespace

bool surely_has_area(const std::array<Vec3, 3>& t) {
  const Cross normal(t[1] - t[0], t[2] - t[0]);
  return normal.side(0) != 0 || normal.side(1) != 0 || normal.side(2) != 0;
}

bool are_surely_apart(const std::array<Vec3, 3>& t, const std::array<Vec3, 3>& u) {
  return is_apart_by_planes_of(t, u) || is_apart_by_planes_of(u, t);
}

bool share_surely_one_corner(const std::array<Vec3, 3>& t, const std::array<Vec3, 3>& u) {
  const Vec3 a = t[1] - t[0], b = t[2] - t[0], c = u[1] - t[0], d = u[2] - t[0];
  if (has_plane_across_corner(a, b, c, d)) return true;
  const Cross ab(a, b), cd(c, d);
  const int of_c = ab.side_of(c), of_a = cd.side_of(a);
  if (of_c != 0 && ab.side_of(d) == of_c) return true;
  if (of_a != 0 && cd.side_of(b) == of_a) return true;
  const Cross ac(a, c), ad(a, d), bc(b, c), bd(b, d);
  return has_plane_through_side(ab, ac, ad, -1) || has_plane_through_side(ab, bc, bd, 1) ||
         has_plane_through_side(cd, ac, bc, 1) || has_plane_through_side(cd, ad, bd, -1);
}

bool share_surely_one_side(const std::array<Vec3, 3>& t, const std::array<Vec3, 3>& u) {
  const Vec3 side = t[1] - t[0], a = t[2] - t[0], b = u[2] - t[0];
  const Cross to_a(side, a), to_b(side, b);
  for (Eigen::Index k = 0; k < 3; ++k) {
    if (to_a.side(k) * to_b.side(k) < 0) return true;
  }
  return to_a.side_of(b) != 0;
}

RayMeeting meet_ray(const std::array<Vec3, 3>& t, const Vec3& p, int axis) {
  const Vec3 a = t[0] - p, b = t[1] - p, c = t[2] - p;
  const int first = Cross(a, b).side(axis), second = Cross(b, c).side(axis), third = Cross(c, a).side(axis);
  const bool has_left = first > 0 || second > 0 || third > 0, has_right = first < 0 || second < 0 || third < 0;
  if (has_left && has_right) return RayMeeting::none;  // the line through p misses the triangle
  if (std::max({t[0][axis], t[1][axis], t[2][axis]}) < p[axis]) return RayMeeting::none;
  if (first == 0 || second == 0 || third == 0) return RayMeeting::unknown;
  // The line passes through the triangle. Its normal points along the axis if p is to the left of its sides.
  const int below = -first * Cross(t[1] - t[0], t[2] - t[0]).side_of(p - t[0]);
  return below > 0 ? RayMeeting::once : below < 0 ? RayMeeting::none : RayMeeting::unknown;
}

}  // namespace gouge::detail
