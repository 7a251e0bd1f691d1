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

/// A linear program over the points y of a box of space and time about the origin that a few half-spaces leave: the
/// largest value that each of up to two limits allows.
class CellProgram {
 public:
  static constexpr std::size_t kMostPlanes = 5, kMostLimits = 2;

  /// The points y with |y_i| <= half_i.
  explicit CellProgram(const Vec4& half) : half_(half) {}

  /// Leaves the points where `plane` is at least 0.
  void keep_behind(const Affine& plane) {
    if (plane_count_ < kMostPlanes) planes_[plane_count_++] = plane;
  }
  void limit(const Affine& limit) {
    if (limit_count_ < kMostLimits) limits_[limit_count_++] = limit;
  }
  /// Proven: one of the half-spaces misses the box.
  [[nodiscard]] bool is_empty() const;

  struct Bound {
    double upper = 0;        ///< min over the limits is no larger anywhere
    Vec4 at = Vec4::Zero();  ///< about where it is largest
    double share = 1;        ///< of the first limit in the blend that bounds it
  };
  /// Ensures  upper bounds the program's value at any rounding but for that of sums: it is a value of its dual. Exact for
  ///          one limit and up to two planes, and for two limits and one plane.
  [[nodiscard]] Bound bound() const;

 private:
  void bound_by_limit(const Affine& limit, double share, Bound& best) const;
  void blend(Bound& best) const;
  void offer(double upper, const Vec4& at, double share, Bound& best) const;
  [[nodiscard]] double spread(const Vec4& gradient) const { return half_.dot(gradient.cwiseAbs()); }
  [[nodiscard]] Vec4 corner(const Vec4& gradient) const;

  Vec4 half_;
  std::array<Affine, kMostPlanes> planes_;
  std::array<Affine, kMostLimits> limits_;
  std::size_t plane_count_ = 0, limit_count_ = 0;
};

}  // namespace gouge
