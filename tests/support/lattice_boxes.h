#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <utility>
#include <vector>

#include "tests/support/scatter.h"
#include "tests/support/shapes.h"

// Boxes with integer coordinates, some of them inside out, in one mesh: shells that nest, overlap, share faces and
// cross. The inside and its boundary are counted cell by cell, without triangles. Header only.

namespace gouge::test {

class LatticeBoxes {
 public:
  static constexpr int kSide = 12;

  /// Makes `count` boxes. With `has_cavities` about half of those after the first face inward.
  LatticeBoxes(Scatter& random, std::size_t count, bool has_cavities) {
    for (std::size_t k = 0; k < count; ++k) {
      One one;
      for (std::size_t a = 0; a < 3; ++a) {
        const int x = static_cast<int>(random.below(kSide + 1)), y = static_cast<int>(random.below(kSide + 1));
        one.low[a] = std::min({x, y, kSide - 2});
        one.high[a] = std::max({x, y, one.low[a] + 2});
      }
      if (k == 0) one = {{1, 1, 1}, {kSide - 1, kSide - 2, kSide - 3}, 1};
      one.sign = k > 0 && has_cavities && random.is(0.5) ? -1 : 1;
      boxes_.push_back(one);
    }
    for (int i = 0; i < kSide * kSide * kSide; ++i) windings_[static_cast<std::size_t>(i)] = counted(cell(i));
    find_faces();
  }

  [[nodiscard]] IndexedMesh mesh() const {
    IndexedMesh all;
    for (const One& one : boxes_) {
      const IndexedMesh box = shapes::box(corner(one.low), corner(one.high));
      all = shapes::joined(std::move(all), one.sign > 0 ? box : shapes::inside_out(box));
    }
    all.name = "boxes";
    return all;
  }

  /// Returns whether a point, which must not lie on a face, is inside.
  [[nodiscard]] bool is_inside(const Vec3& point) const {
    Cell at{};
    for (std::size_t a = 0; a < 3; ++a) at[a] = static_cast<int>(std::floor(point[static_cast<Eigen::Index>(a)]));
    return winding(at) != 0;
  }

  /// Returns the distance from a point on either side to the surface on which the winding number changes between 0 and
  /// another.
  [[nodiscard]] double distance_mm(const Vec3& point) const {
    double least2 = 1e300;
    for (const Box3& face : faces_) least2 = std::min(least2, face.squaredExteriorDistance(point));
    return std::sqrt(least2);
  }
  /// Returns the distance to that surface for a point inside, 0 for a point outside.
  [[nodiscard]] double depth_mm(const Vec3& point) const { return is_inside(point) ? distance_mm(point) : 0; }

 private:
  using Cell = std::array<int, 3>;
  struct One {
    Cell low{}, high{};
    int sign = 1;
  };

  static Cell cell(int i) { return {i % kSide, i / kSide % kSide, i / (kSide * kSide)}; }
  static Vec3 corner(const Cell& at) { return Vec3(at[0], at[1], at[2]); }

  [[nodiscard]] int counted(const Cell& at) const {
    int sum = 0;
    for (const One& one : boxes_) {
      bool is_in = true;
      for (std::size_t a = 0; a < 3; ++a) is_in = is_in && at[a] >= one.low[a] && at[a] < one.high[a];
      if (is_in) sum += one.sign;
    }
    return sum;
  }
  [[nodiscard]] int winding(const Cell& at) const {
    const bool is_within = std::min({at[0], at[1], at[2]}) >= 0 && std::max({at[0], at[1], at[2]}) < kSide;
    return is_within ? windings_[static_cast<std::size_t>((at[2] * kSide + at[1]) * kSide + at[0])] : 0;
  }

  void find_faces() {
    for (int i = 0; i < kSide * kSide * kSide; ++i) {
      const Cell at = cell(i);
      for (std::size_t a = 0; a < 3; ++a) {
        for (const int step : {-1, 1}) {
          Cell other = at;
          other[a] += step;
          if (winding(at) == 0 || winding(other) != 0) continue;
          Box3 face(corner(at), Vec3(corner(at) + Vec3::Ones()));
          const auto axis = static_cast<Eigen::Index>(a);
          (step < 0 ? face.max()[axis] = face.min()[axis] : face.min()[axis] = face.max()[axis]);
          faces_.push_back(face);
        }
      }
    }
  }

  std::vector<One> boxes_;
  std::array<int, static_cast<std::size_t>(kSide) * kSide * kSide> windings_{};
  std::vector<Box3> faces_;
};

}  // namespace gouge::test
