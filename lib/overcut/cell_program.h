#pragma once

#include <array>
#include <cstddef>

#include <Eigen/Core>

namespace gouge {

using Vec4 = Eigen::Vector4d;

/// The affine function value + gradient . y
struct Affine {
  double value = 0;
  Vec4 gradient = Vec4::Zero();

  [[nodiscard]] double at(const Vec4& y) const { return value + gradient.dot(y); }
};

/// A linear program over the points y of a box of space and time about the origin, cut by a few half-spaces. It
/// maximizes the minimum of a few limits.
class CellProgram {
 public:
  static constexpr std::size_t kMaxPlanes = 10, kMaxLimits = 4;

  /// Begins with all points y with |y_i| <= half_i.
  explicit CellProgram(const Vec4& half) : half_(half) {}

  /// Keeps only the points at which `plane` is at least 0.
  void keep_behind(const Affine& plane) {
    if (plane_count_ < kMaxPlanes) planes_[plane_count_++] = plane;
  }
  void limit(const Affine& limit) {
    if (limit_count_ < kMaxLimits) limits_[limit_count_++] = limit;
  }
  /// Raises limit `k` by `by`.
  void raise(std::size_t k, double by) { limits_[k].value += by; }
  [[nodiscard]] bool is_full() const { return plane_count_ == kMaxPlanes || limit_count_ == kMaxLimits; }

  struct Bound {
    double upper = 0;        ///< upper bound of the minimum over the limits; -infinity: the program is proved to be
                             ///< empty
    Vec4 at = Vec4::Zero();  ///< approximate place of the maximum
    std::array<double, kMaxLimits> share = {};  ///< weight of each limit in the blend that gives the bound
    Affine least;  ///< the blend: at least the minimum over the limits at each point behind all planes
  };
  /// Bounds the program. Requires a limit.
  /// Ensures  The result is an upper bound of the program's value, because it is a value of its dual. This holds for
  ///          any rounding except that of sums. Apart from rounding it is the program's own value.
  /// Cost     Below a microsecond.
  [[nodiscard]] Bound bound() const;

  struct Range {
    Vec4 low, high;
  };
  /// Returns a part of the box that contains all points that are behind all planes and at which every limit is at least
  /// `value`. If low > high in some coordinate, there is no such point. `bound` is the bound of this program.
  [[nodiscard]] Range where_at_least(double value, const Bound& bound) const;

 private:
  [[nodiscard]] double spread(const Vec4& gradient) const { return half_.dot(gradient.cwiseAbs()); }
  [[nodiscard]] Affine blend_of(const std::array<double, kMaxPlanes + kMaxLimits>& weights) const;

  Vec4 half_;
  std::array<Affine, kMaxPlanes> planes_;
  std::array<Affine, kMaxLimits> limits_;
  std::size_t plane_count_ = 0, limit_count_ = 0;
};

}  // namespace gouge
