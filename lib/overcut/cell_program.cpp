#include "lib/overcut/cell_program.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/base/tolerance.h"

// Any weights bound the program, if those of limits add up to 1 and those of planes are not negative. The bound is the
// sum of weighted values + half . |sum of weighted gradients|. Good weights come from the dual simplex method. It
// begins at the corner of the box where the first limit is largest. It then adds the constraint that this point
// violates most, until it violates none. The bound holds for the weights in spite of their rounding.

namespace gouge {
namespace {

using Vec5 = Eigen::Matrix<double, 5, 1>;  // y, and the value
using Mat5 = Eigen::Matrix<double, 5, 5>;

constexpr double kPivot = 1e-11;
constexpr double kViolated_mm = 1e-8;
constexpr int kMaxPivots = 30;
constexpr double kLevel = 1e-4;  // minimum slope of a limit whose end is computed

/// A linear program: the largest v in a box of y with v <= limit(y) for all limits and plane(y) >= 0 for all planes.
/// Its rows are n . (y, v) <= b.
class DualSimplex {
 public:
  explicit DualSimplex(const Vec4& half) {
    for (int i = 0; i < 4; ++i) {
      for (const double side : {1.0, -1.0}) {
        Vec5 n = Vec5::Zero();
        n[i] = side;
        rows_[count_++] = {n, half[i]};
      }
    }
  }
  /// Adds a row. `of_value` is 1 for a limit and 0 for a plane.
  void add(const Affine& part, double of_value) {
    Vec5 n;
    n << -part.gradient, of_value;
    rows_[count_++] = {n, part.value};
  }

  /// Runs the method. It begins at the first limit, whose gradient is `first`.
  void run(const Vec4& first) {
    for (std::size_t i = 0; i < 4; ++i) {
      const auto axis = static_cast<Eigen::Index>(i);
      const bool is_up = first[axis] >= 0;
      basis_[i] = 2 * i + (is_up ? 0 : 1);
      inverse_(axis, axis) = is_up ? 1 : -1;
      inverse_(4, axis) = weights_[axis] = std::abs(first[axis]);
    }
    basis_[4] = kSides;
    inverse_(4, 4) = weights_[4] = 1;
    for (int k = 0; k < kMaxPivots; ++k) {
      Vec5 offsets;
      for (std::size_t i = 0; i < 5; ++i) offsets[static_cast<Eigen::Index>(i)] = rows_[basis_[i]].offset;
      at_ = inverse_ * offsets;
      entering_ = max_violated();
      if (entering_ == kNone || !pivot()) return;
    }
  }

  /// Returns whether no point is behind all planes. Then the weights are those of planes that together miss the box.
  [[nodiscard]] bool is_empty() const { return is_empty_; }
  /// Returns the weight of the k-th added part; it may be slightly negative.
  [[nodiscard]] double weight(std::size_t k) const {
    if (is_empty_ && k + kSides == entering_) return 1;
    for (std::size_t i = 0; i < 5; ++i) {
      if (basis_[i] == k + kSides) return weights_[static_cast<Eigen::Index>(i)];
    }
    return 0;
  }
  [[nodiscard]] Vec4 at() const { return at_.head<4>(); }

 private:
  static constexpr std::size_t kSides = 8, kNone = 1000;
  struct Row {
    Vec5 n;
    double offset = 0;
  };

  [[nodiscard]] std::size_t max_violated() const {
    std::size_t worst = kNone;
    double most = kViolated_mm;
    for (std::size_t k = 0; k < count_; ++k) {
      const double over = rows_[k].n.dot(at_) - rows_[k].offset;
      if (!(over > most)) continue;
      most = over;
      worst = k;
    }
    return worst;
  }

  /// Adds the entering row. Returns false if it excludes all points.
  bool pivot() {
    const Vec5 share = inverse_.transpose() * rows_[entering_].n;
    Eigen::Index leaving = -1;
    double least = std::numeric_limits<double>::infinity();
    for (Eigen::Index i = 0; i < 5; ++i) {
      if (!(share[i] > kPivot)) continue;
      const double ratio = std::max(0.0, weights_[i]) / share[i];
      if (ratio >= least) continue;
      least = ratio;
      leaving = i;
    }
    if (leaving < 0) {
      is_empty_ = true;
      weights_ = -share;
      return false;
    }
    weights_ -= least * share;
    weights_[leaving] = least;
    Vec5 change = share;
    change[leaving] -= 1;
    inverse_ -= (inverse_.col(leaving) / share[leaving]) * change.transpose();
    basis_[static_cast<std::size_t>(leaving)] = entering_;
    return true;
  }

  std::array<Row, kSides + CellProgram::kMaxPlanes + CellProgram::kMaxLimits> rows_;
  std::size_t count_ = 0, entering_ = kNone;
  std::array<std::size_t, 5> basis_{};
  Mat5 inverse_ = Mat5::Zero();  // inverse of the matrix whose rows are those of the basis
  Vec5 at_ = Vec5::Zero(), weights_ = Vec5::Zero();
  bool is_empty_ = false;
};

}  // namespace

Affine CellProgram::blend_of(const std::array<double, kMaxPlanes + kMaxLimits>& weights) const {
  Affine blend;
  for (std::size_t k = 0; k < plane_count_ + limit_count_; ++k) {
    if (!(weights[k] > 0)) continue;
    const Affine& part = k < limit_count_ ? limits_[k] : planes_[k - limit_count_];
    blend.value += weights[k] * part.value;
    blend.gradient += weights[k] * part.gradient;
  }
  return blend;
}

CellProgram::Bound CellProgram::bound() const {
  DualSimplex simplex(half_);
  for (std::size_t k = 0; k < limit_count_; ++k) simplex.add(limits_[k], 1);
  for (std::size_t k = 0; k < plane_count_; ++k) simplex.add(planes_[k], 0);
  simplex.run(limits_[0].gradient);
  std::array<double, kMaxPlanes + kMaxLimits> weights{};
  for (std::size_t k = 0; k < limit_count_ + plane_count_; ++k) weights[k] = std::max(0.0, simplex.weight(k));
  Bound bound;
  if (simplex.is_empty()) {
    std::fill_n(weights.begin(), limit_count_, 0.0);
    const Affine miss = blend_of(weights);
    bound.upper = -std::numeric_limits<double>::infinity();
    if (miss.value + spread(miss.gradient) < 0) return bound;
    weights.fill(0);
  }
  double sum = 0;
  for (std::size_t k = 0; k < limit_count_; ++k) sum += weights[k];
  if (!(sum > kPivot)) {
    weights.fill(0);
    weights[0] = sum = 1;
  }
  for (double& weight : weights) weight /= sum;
  bound.least = blend_of(weights);
  bound.upper = bound.least.value + spread(bound.least.gradient);
  bound.at = simplex.at().cwiseMin(half_).cwiseMax(-half_);
  for (std::size_t k = 0; k < limit_count_; ++k) bound.share[k] = weights[k];
  return bound;
}

CellProgram::Range CellProgram::where_at_least(double value, const Bound& bound) const {
  Range range{-half_, half_};
  const auto narrow = [&](const Affine& part, double least) {
    Vec4 most;
    for (int i = 0; i < 4; ++i) most[i] = std::max(part.gradient[i] * range.low[i], part.gradient[i] * range.high[i]);
    const double all = part.value - least + most.sum();
    for (int i = 0; i < 4; ++i) {
      const double slope = part.gradient[i];
      if (!(std::abs(slope) > kLevel)) continue;
      const double end = (most[i] - all) / slope;  // position at which the part is `least` if all other coordinates are
                                                   // at their best
      if (slope > 0) range.low[i] = std::max(range.low[i], end - Tolerance::kRounding);
      if (slope < 0) range.high[i] = std::min(range.high[i], end + Tolerance::kRounding);
    }
  };
  for (int round = 0; round < 2; ++round) {
    narrow(bound.least, value);
    for (std::size_t k = 0; k < limit_count_; ++k) narrow(limits_[k], value);
    for (std::size_t k = 0; k < plane_count_; ++k) narrow(planes_[k], 0);
  }
  return range;
}

}  // namespace gouge
