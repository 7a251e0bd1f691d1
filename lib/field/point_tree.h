#pragma once

#include <cstddef>
#include <vector>

#include "lib/geom/vec.h"

namespace gouge {

/// Points in a tree of boxes, halved at the median of the longest side, and cut into blocks that share no point, so
/// that threads may work on them in any order.
///
/// The trees of lib/hierarchy and lib/kdop hold surfaces that stand still for many queries; this one is built for a
/// single pass over points that know their own values.
class PointTree {
 public:
  static constexpr std::size_t kLeafPoints = 16;

  struct Node {
    Box3 box;
    Vec3 centre = Vec3::Zero();
    double radius = 0;                ///< of a ball about the box
    std::size_t first = 0, last = 0;  ///< in order()
    std::size_t child = 0;            ///< of two neighbours, which come behind it; 0: a leaf
  };

  explicit PointTree(const std::vector<Vec3>& points);

  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
  /// The points, leaf by leaf.
  [[nodiscard]] const std::vector<std::size_t>& order() const { return order_; }
  /// Nodes that share no point and hold all.
  [[nodiscard]] const std::vector<std::size_t>& blocks() const { return blocks_; }

 private:
  void fill(const std::vector<Vec3>& points, std::size_t at, std::size_t first, std::size_t last, std::size_t block,
            bool is_in_block);

  std::vector<Node> nodes_;
  std::vector<std::size_t> order_, blocks_;
};

}  // namespace gouge
