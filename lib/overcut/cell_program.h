#pragma once

#include <array>
#include <cstddef>

#include <Eigen/Core>

namespace gouge {

using Vec4 = Eigen::Vector4d;

/// value + gradient . y
struct Affine {
  double value = 0;
  Vec4 gradient = Vec4::Zero();

  [[nodiscard]] double at(const Vec4& y) const { return value + gradient.dot(y); }
};

/// A linear program over the points y of a box of space and time about the origin, cut by a few half-spaces. Its value
/// is the largest one that all of a few limits allow.
class CellProgram {
 public:
  static constexpr std::size_t kMaxPlanes = 10, kMaxLimits = 4;

  /// The points y with |y_i| <= half_i.
  explicit CellProgram(const Vec4& half) : half_(half) {}

  /// Leaves the points where `plane` is at least 0.
  void keep_behind(const Affine& plane) {
    if (plane_count_ < kMaxPlanes) planes_[plane_count_++] = plane;
  }
  void limit(const Affine& limit) {
    if (limit_count_ < kMaxLimits) limits_[limit_count_++] = limit;
  }
  /// Lets limit `k` allow so much more.
  void raise(std::size_t k, double by) { limits_[k].value += by; }
  [[nodiscard]] bool is_full() const { return plane_count_ == kMaxPlanes || limit_count_ == kMaxLimits; }

  struct Bound {
    double upper = 0;        ///< min over the limits is no larger anywhere; -infinity: proven to be empty
    Vec4 at = Vec4::Zero();  ///< about where it is largest
    std::array<double, kMaxLimits> share = {};  ///< of each limit in the blend that bounds it
    Affine least;  ///< the blend: at least min over the limits wherever that is behind all planes
  };
  /// Requires a limit.
  /// Ensures  Upper bounds the program's value at any rounding but for that of sums: it is a value of its dual. The
  ///          program's own value but for rounding.
  /// Cost     Below a microsecond.
  [[nodiscard]] Bound bound() const;

  struct Range {
    Vec4 low, high;
  };
  /// Returns a part of the box with all of its points that are behind all planes and where every limit allows at least
  /// `value`. With low > high somewhere there is no such point. `bound`: of this program.
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
