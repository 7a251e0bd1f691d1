#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "lib/geom/vec.h"

namespace gouge {

/// A tree of boxes over points in the order they come in, halved in the middle. It is quick to make for a single pass
/// over points. Neighbours in their list should be neighbours in space, as in a picture. In any other order it holds as
/// well, but its boxes are large. It is cut into blocks that share no point, so that threads may work on them in any
/// order.
///
/// The trees of lib/hierarchy and lib/kdop hold surfaces that stand still for many queries.
class PointTree {
 public:
  static constexpr std::size_t kLeafPoints = 16;

  struct Node {
    Box3 box;
    Vec3 centre = Vec3::Zero();
    double radius = 0;                ///< of a ball about the box
    Vec3 normal = Vec3::Zero();       ///< of a plane through the centre near the points, unit or zero
    double off_mm = 0;                ///< no point is farther from that plane
    std::size_t first = 0, last = 0;  ///< its points
    std::size_t child = 0;            ///< of two neighbours, which come behind it; 0: a leaf
    bool is_block = false;            ///< no node below it is one; every point is in one
  };

  /// `at(i)` is point i of `count`.
  template <class At>
  PointTree(std::size_t count, At&& at) {
    if (count == 0) return;
    nodes_.reserve(4 * (count / kLeafPoints + 1));
    split(count);
    for (std::size_t n = nodes_.size(); n-- > 0;) {
      Node& node = nodes_[n];
      if (node.child == 0) {
        for (std::size_t i = node.first; i < node.last; ++i) node.box.extend(at(i));
      } else {
        node.box = nodes_[node.child].box.merged(nodes_[node.child + 1].box);
      }
      node.centre = node.box.center();
      node.radius = 0.5 * node.box.diagonal().norm();
      flatten(node, at);
    }
  }

  /// Returns the root first; none without points.
  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }

  /// Returns a bound of direction . (p - centre) for all points p of the node. Requires a unit direction.
  [[nodiscard]] static double reach_mm(const Node& node, const Vec3& direction) {
    const double along = std::abs(direction.dot(node.normal));
    const double across = std::sqrt(std::max(0.0, 1 - along * along));
    return std::min(node.radius, along * node.off_mm + across * node.radius);
  }

 private:
  void split(std::size_t count);

  // The plane across the diagonals of the four points that are the corners where points come along Morton's curve.
  template <class At>
  void flatten(Node& node, const At& at) {
    const std::size_t rest = node.last - node.first - 1;
    const Vec3 a = at(node.first + rest) - at(node.first);
    const Vec3 b = at(node.first + 2 * rest / 3) - at(node.first + rest / 3);
    const Vec3 square = a.cross(b);
    const double length = square.norm();
    if (!(length > 0)) return;
    node.normal = square / length;
    if (node.child == 0) {
      for (std::size_t i = node.first; i < node.last; ++i)
        node.off_mm = std::max(node.off_mm, std::abs(node.normal.dot(at(i) - node.centre)));
      return;
    }
    for (const std::size_t k : {node.child, node.child + 1}) {
      const Node& child = nodes_[k];
      node.off_mm =
          std::max(node.off_mm, std::abs(node.normal.dot(child.centre - node.centre)) + reach_mm(child, node.normal));
    }
  }

  std::vector<Node> nodes_;
};

}  // namespace gouge
