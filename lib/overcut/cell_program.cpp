#include "lib/overcut/cell_program.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

// Any weights of limits, adding up to 1, and of planes, none negative, bound the program:
//   sum of weighted values + half . |sum of weighted gradients|.
// That is convex and piecewise linear in the weights, so its least value is at a corner: where one gradient component
// vanishes for each weight that is free.

namespace gouge {
namespace {

constexpr double kParallel = 1e-12;
constexpr int kAxes = 4;
constexpr std::array<std::pair<int, int>, 6> kPairs = {{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

/// The solution of a x + b y = e, c x + d y = f; nothing where it is not unique.
bool solve(double a, double b, double c, double d, double e, double f, double& x, double& y) {
  const double determinant = a * d - b * c;
  if (!(std::abs(determinant) > kParallel)) return false;
  x = (e * d - b * f) / determinant;
  y = (a * f - c * e) / determinant;
  return true;
}

}  // namespace

bool CellProgram::is_empty() const {
  for (std::size_t k = 0; k < plane_count_; ++k) {
    if (planes_[k].value + spread(planes_[k].gradient) < 0) return true;
  }
  return false;
}

Vec4 CellProgram::corner(const Vec4& gradient) const {
  Vec4 y;
  for (int i = 0; i < kAxes; ++i) y[i] = std::copysign(half_[i], gradient[i]);
  return y;
}

void CellProgram::offer(double upper, const Vec4& at, double share, Bound& best) const {
  if (!(upper < best.upper)) return;
  best.upper = upper;
  best.at = at.cwiseMin(half_).cwiseMax(-half_);
  best.share = share;
}

void CellProgram::bound_by_limit(const Affine& limit, double share, Bound& best) const {
  const Vec4& f = limit.gradient;
  offer(limit.value + spread(f), corner(f), share, best);
  for (std::size_t k = 0; k < plane_count_; ++k) {
    const Affine& p = planes_[k];
    for (int i = 0; i < kAxes; ++i) {
      if (!(f[i] * p.gradient[i] < 0)) continue;
      const double weight = -f[i] / p.gradient[i];
      const Vec4 rest = f + weight * p.gradient;
      Vec4 at = corner(rest);
      at[i] = 0;
      at[i] = -p.at(at) / p.gradient[i];
      offer(limit.value + weight * p.value + spread(rest), at, share, best);
    }
    for (std::size_t l = 0; l < k; ++l) {
      const Affine& q = planes_[l];
      for (const auto& [i, j] : kPairs) {
        double wp = 0, wq = 0;
        if (!solve(p.gradient[i], q.gradient[i], p.gradient[j], q.gradient[j], -f[i], -f[j], wp, wq)) continue;
        if (wp < 0 || wq < 0) continue;
        const Vec4 rest = f + wp * p.gradient + wq * q.gradient;
        Vec4 at = corner(rest);
        at[i] = at[j] = 0;
        double yi = 0, yj = 0;
        solve(p.gradient[i], p.gradient[j], q.gradient[i], q.gradient[j], -p.at(at), -q.at(at), yi, yj);
        at[i] = yi;
        at[j] = yj;
        offer(limit.value + wp * p.value + wq * q.value + spread(rest), at, share, best);
      }
    }
  }
}

void CellProgram::blend(Bound& best) const {
  const Affine &a = limits_[0], &b = limits_[1];
  const Vec4 difference = a.gradient - b.gradient;
  const auto mixed = [&](double share) {
    return Affine{share * a.value + (1 - share) * b.value, b.gradient + share * difference};
  };
  for (int i = 0; i < kAxes; ++i) {
    if (!(std::abs(difference[i]) > kParallel)) continue;
    const double share = -b.gradient[i] / difference[i];
    if (share > 0 && share < 1) bound_by_limit(mixed(share), share, best);
  }
  for (std::size_t k = 0; k < plane_count_; ++k) {
    const Affine& p = planes_[k];
    for (const auto& [i, j] : kPairs) {
      double share = 0, weight = 0;
      if (!solve(difference[i], p.gradient[i], difference[j], p.gradient[j], -b.gradient[i], -b.gradient[j], share,
                 weight))
        continue;
      if (!(share > 0 && share < 1) || weight < 0) continue;
      const Affine both = mixed(share);
      const Vec4 rest = both.gradient + weight * p.gradient;
      offer(both.value + weight * p.value + spread(rest), best.at, share, best);
    }
  }
}

CellProgram::Bound CellProgram::bound() const {
  Bound best;
  best.upper = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < limit_count_; ++k) bound_by_limit(limits_[k], k == 0 ? 1 : 0, best);
  if (limit_count_ == 2) blend(best);
  return best;
}

}  // namespace gouge
