#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "lib/geom/vec.h"

namespace gouge {

/// A tree of boxes over points in their given order, which is halved in the middle. It is fast to build, for a single
/// pass over the points. Neighbours in the list should be neighbours in space, as in a picture. In any other order the
/// tree is still valid, but its boxes are large. It is cut into blocks that share no point, so that threads may work on
/// them in any order.
///
/// The trees of lib/hierarchy and lib/kdop contain surfaces that do not move during many queries.
class PointTree {
 public:
  static constexpr std::size_t kLeafPoints = 16;

  struct Node {
    Box3 box;
    Vec3 centre = Vec3::Zero();
    double radius = 0;                ///< radius of a ball about the box
    Vec3 normal = Vec3::Zero();       ///< normal of a plane through the centre near the points; unit or zero
    double off_mm = 0;                ///< maximum distance of a point from that plane
    std::size_t first = 0, last = 0;  ///< range of its points
    std::size_t child = 0;            ///< index of the first of two neighbouring children, which come after the node;
                                      ///< 0: a leaf
    bool is_block = false;            ///< no node below it is a block, and every point is in exactly one block
  };

  /// Builds the tree. `at(i)` returns point i of `count`.
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

  /// Returns the nodes, the root first; empty without points.
  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }

  /// Returns an upper bound of direction . (p - centre) for all points p of the node. Requires a unit direction.
  [[nodiscard]] static double reach_mm(const Node& node, const Vec3& direction) {
    const double along = std::abs(direction.dot(node.normal));
    const double across = std::sqrt(std::max(0.0, 1 - along * along));
    return std::min(node.radius, along * node.off_mm + across * node.radius);
  }

 private:
  void split(std::size_t count);

  // Finds the plane across the diagonals of four points. These are the corners if the points are ordered along Morton's
  // curve.
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
