#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "lib/mesh/indexed_mesh.h"

namespace gouge::detail {

[[nodiscard]] std::vector<std::uint32_t> all_triangles(const IndexedMesh& mesh);

/// An index of a mesh's triangles whose boxes intersect. It traverses a binary tree of boxes, with eight triangles per
/// leaf, against itself. Boxes are exact, so that far corners do not make the boxes of near triangles intersect.
class NearTriangles {
 public:
  /// Builds the tree. Requires finite coordinates. Cost O(n log n); 70 bytes a triangle, and 32 more during the
  /// construction.
  NearTriangles(const IndexedMesh& mesh, const std::vector<std::uint32_t>& triangles);

  /// Returns the number of parts of the search for pairs. The parts may be searched in any order and at the same time.
  [[nodiscard]] std::size_t parts() const { return parts_.size(); }

  /// Calls visit(t, u) for pairs of triangles whose boxes intersect. Over all parts each pair is visited once, in no
  /// guaranteed order.
  /// Cost     O(n log n) over all parts for surfaces of real parts.
  template <typename Visit>
  void for_each_pair(std::size_t part, const Visit& visit) const {
    walk(parts_[part], {0, 0, leaves_.size()}, visit);
  }

  /// Calls visit(t) once for each triangle whose box intersects `box`. Cost O(log n) plus the visited triangles.
  template <typename Visit>
  void for_each_at(const Box3& box, const Visit& visit) const {
    if (!leaves_.empty()) look_at({0, 0, leaves_.size()}, box, visit);
  }

 private:
  static constexpr std::size_t kLanes = 8;

  using LaneValues = std::array<double, kLanes>;
  struct Leaf {
    std::array<LaneValues, 3> low, high;
    std::array<std::uint32_t, kLanes> triangle{};
    std::size_t count = 0;
  };

  /// A subtree: the position of its box, and its leaves. The left child follows its parent; the right child follows the
  /// left subtree.
  struct Range {
    std::size_t node = 0, first = 0, last = 0;
    [[nodiscard]] std::size_t size() const { return last - first; }
    [[nodiscard]] std::size_t middle() const { return first + size() / 2; }
    [[nodiscard]] Range left() const { return {node + 1, first, middle()}; }
    [[nodiscard]] Range right() const { return {node + 2 * (middle() - first), middle(), last}; }
  };

  struct Centre {
    std::array<double, 3> at;
    std::uint32_t triangle = 0;
  };

  static void sort(std::vector<Centre>& centres, const Range& all);
  static void sort_whole(std::vector<Centre>& centres, const Range& range);
  static void halve(std::vector<Centre>& centres, const Range& range);
  void fill(const IndexedMesh& mesh, const std::vector<Centre>& centres, std::size_t leaf);
  Box3 bound(const Range& range);
  void cut(const Range& range);

  // Visits the pairs of a leaf in `some` with itself or with a later leaf in `all`.
  template <typename Visit>
  void walk(const Range& some, const Range& all, const Visit& visit) const {
    if (all.last <= some.first || !boxes_[some.node].intersects(boxes_[all.node])) return;
    if (some.size() == 1 && all.size() == 1) {
      meet(leaves_[some.first], leaves_[all.first], some.first == all.first, boxes_[all.node], visit);
    } else if (some.size() > all.size()) {
      walk(some.left(), all, visit);
      walk(some.right(), all, visit);
    } else {
      walk(some, all.left(), visit);
      walk(some, all.right(), visit);
    }
  }

  template <typename Visit>
  void look_at(const Range& range, const Box3& box, const Visit& visit) const {
    if (!boxes_[range.node].intersects(box)) return;
    if (range.size() > 1) {
      look_at(range.left(), box, visit);
      look_at(range.right(), box, visit);
      return;
    }
    const Leaf& leaf = leaves_[range.first];
    for (std::size_t i = 0; i < leaf.count; ++i) {
      const Vec3 low(leaf.low[0][i], leaf.low[1][i], leaf.low[2][i]);
      const Vec3 high(leaf.high[0][i], leaf.high[1][i], leaf.high[2][i]);
      if (Box3(low, high).intersects(box)) visit(leaf.triangle[i]);
    }
  }

  template <typename Visit>
  static void meet(const Leaf& some, const Leaf& other, bool is_same, const Box3& box, const Visit& visit) {
    for (std::size_t i = 0; i < some.count; ++i) {
      std::array<double, 3> low{}, high{};
      for (std::size_t k = 0; k < 3; ++k) low[k] = some.low[k][i], high[k] = some.high[k][i];
      if (low[0] > box.max().x() || low[1] > box.max().y() || low[2] > box.max().z()) continue;
      if (high[0] < box.min().x() || high[1] < box.min().y() || high[2] < box.min().z()) continue;
      for (std::size_t j = is_same ? i + 1 : 0; j < other.count; ++j) {
        bool is_near = true;
        for (std::size_t k = 0; k < 3; ++k) is_near &= low[k] <= other.high[k][j] && other.low[k][j] <= high[k];
        if (is_near) visit(some.triangle[i], other.triangle[j]);
      }
    }
  }

  std::vector<Leaf> leaves_;
  std::vector<Box3> boxes_;  // by node
  std::vector<Range> parts_;
};

}  // namespace gouge::detail
