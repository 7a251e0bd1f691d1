#pragma once

#include <Eigen/Core>

namespace gouge {

/// J, the discrete integral of |w''|^2 over the length of a path on which the vector w changes. The sum is over
/// neighbouring pieces, with terms |slope - slope before|^2 * 2 / (length + length before). The slope of a piece is dw
/// / length.
template <int dimensions>
class BendingSum {
 public:
  using Slope = Eigen::Matrix<double, dimensions, 1>;

  /// Adds one more piece. Requires a length above 0.
  void add(const Slope& slope, double length_mm) {
    if (has_last_) value_ += (slope - last_slope_).squaredNorm() * 2 / (last_length_mm_ + length_mm);
    last_slope_ = slope;
    last_length_mm_ = length_mm;
    has_last_ = true;
  }

  /// Separates the next piece from the one before it.
  void interrupt() { has_last_ = false; }

  [[nodiscard]] double value() const { return value_; }

 private:
  double value_ = 0;
  Slope last_slope_ = Slope::Zero();
  double last_length_mm_ = 0;
  bool has_last_ = false;
};

}  // namespace gouge
