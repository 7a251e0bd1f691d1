#include "lib/validate/triangle_filter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace gouge::detail {
namespace {

// Relative to the sum of the absolute products, with u = 2^-53: u (4, 8 and 5 for 3 + 16 u, 7 + 56 u and 4 + 16 u; the
// rest covers the rounding of the bound itself). Absolute: the loss of products below the smallest normal numbers.
constexpr double kUnit = 1.1102230246251565e-16;
constexpr double kArea = 4 * kUnit, kVolume = 8 * kUnit, kDot = 5 * kUnit, kUnderflow = 1e-200;

int sign_of(double value, double error) { return value > error ? 1 : value < -error ? -1 : 0; }

/// The cross product of two differences of points, and the sums of its products' absolute values.
struct Cross {
  Cross(const Vec3& u, const Vec3& v) {
    for (Eigen::Index k = 0; k < 3; ++k) {
      const Eigen::Index i = (k + 1) % 3, j = (k + 2) % 3;
      const double plus = u[i] * v[j], minus = u[j] * v[i];
      value[k] = plus - minus;
      magnitude[k] = std::abs(plus) + std::abs(minus);
    }
  }

  /// On which side of the line along u, seen along axis k, v is; 0: not known.
  [[nodiscard]] int side(Eigen::Index k) const { return sign_of(value[k], kArea * magnitude[k] + kUnderflow); }

  /// On which side of the plane along u and v the difference of points w is; 0: not known.
  [[nodiscard]] int side_of(const Vec3& w) const {
    return sign_of(value.dot(w), kVolume * magnitude.dot(w.cwiseAbs()) + kUnderflow);
  }

  Vec3 value, magnitude;
};

/// Returns whether the difference of points w makes a sharp angle with the direction n.
bool is_surely_along(const Vec3& n, const Vec3& w) {
  return n.dot(w) > kDot * n.cwiseAbs().dot(w.cwiseAbs()) + kUnderflow;
}

/// Tests a plane across the common corner with t beyond it on one side and u on the other. The vectors a, b and c, d
/// lead from that corner to the others of t and of u.
bool has_plane_across_corner(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 n = a / a.norm() + b / b.norm() - c / c.norm() - d / d.norm();
  return is_surely_along(n, a) && is_surely_along(n, b) && is_surely_along(-n, c) && is_surely_along(-n, d);
}

/// Tests a plane through one side from the common corner and an axis of coordinates. The rest of that side's triangle
/// is on one side of it and the other triangle on the other. The product `third` is that of the side with its own
/// triangle's other one; `one` and `other` are those with the sides of the other triangle. With `turned` 1 one of the
/// two orders is reversed.
bool has_plane_through_side(const Cross& third, const Cross& one, const Cross& other, int turned) {
  for (Eigen::Index k = 0; k < 3; ++k) {
    const int beyond = turned * third.side(k);
    if (beyond != 0 && one.side(k) == beyond && other.side(k) == beyond) return true;
  }
  return false;
}

/// Tests the plane of t with u strictly on one side. Else tests one through a side of t and along an axis, with t on
/// one side of it and u strictly on the other.
bool is_apart_by_planes_of(const std::array<Vec3, 3>& t, const std::array<Vec3, 3>& u) {
  const Cross normal(t[1] - t[0], t[2] - t[0]);
  const int side = normal.side_of(u[0] - t[0]);
  if (side != 0 && normal.side_of(u[1] - t[0]) == side && normal.side_of(u[2] - t[0]) == side) return true;
  for (std::size_t s = 0; s < 3; ++s) {
    const Vec3 &from = t[s], &to = t[(s + 1) % 3];
    const Cross first(to - from, u[0] - from), second(to - from, u[1] - from), third(to - from, u[2] - from);
    for (Eigen::Index k = 0; k < 3; ++k) {
      const int own = normal.side(k);  // of the third corner, whichever side of t it is
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
  if (has_left && has_right) return RayMeeting::none;  // the line through p passes beside it
  if (std::max({t[0][axis], t[1][axis], t[2][axis]}) < p[axis]) return RayMeeting::none;
  if (first == 0 || second == 0 || third == 0) return RayMeeting::unknown;
  // The line passes through it, and its normal points along the axis where p is to the left of its sides.
  const int below = -first * Cross(t[1] - t[0], t[2] - t[0]).side_of(p - t[0]);
  return below > 0 ? RayMeeting::once : below < 0 ? RayMeeting::none : RayMeeting::unknown;
}

}  // namespace gouge::detail
