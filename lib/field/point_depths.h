#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "lib/base/parallel.h"
#include "lib/field/point_tree.h"

namespace gouge {

/// A point of the surface, part coordinates.
struct FieldPoint {
  Vec3 at = Vec3::Zero();
  bool is_fixture = false;
};

/// Points of a surface, each with the largest depth found so far, so that a body at a pose visits only the points that
/// it can reach deeper than that.
class PointDepths {
 public:
  static constexpr double kUnseen = 1.03;  ///< a depth not above this many times another looks the same
  using LeafDepths = std::array<float, PointTree::kLeafPoints>;

  explicit PointDepths(const std::vector<FieldPoint>& points)
      : tree_(positions(points)), depth_(points.size(), 0.0F), least_(tree_.nodes().size(), 0.0F) {
    sorted_.reserve(points.size());
    for (const std::size_t i : tree_.order()) sorted_.push_back(points[i]);
  }

  /// The largest depth of each point in any of the bodies, in mm, less 3 % at most; 0 where it is in none.
  ///
  /// A Body has most_mm(node, enough_mm): no point of the node is deeper, as exact as it need be where that is not
  /// above `enough_mm`; depths(points of a leaf, found): of those deeper than found so far; and floor_mm(): all that it
  /// gives are more. It may remember what it found: every block gets a copy of its own.
  template <class Body>
  [[nodiscard]] std::vector<float> deepest(const std::vector<Body>& bodies) {
    const std::vector<std::size_t>& blocks = tree_.blocks();
    for_each_chunk(blocks.size(), 1, 0, [&](std::size_t first, std::size_t last) {
      for (std::size_t b = first; b < last; ++b) {
        for (Body body : bodies) visit(blocks[b], body);
      }
    });
    std::vector<float> out(depth_.size());
    for (std::size_t i = 0; i < out.size(); ++i) out[tree_.order()[i]] = depth_[i];
    return out;
  }

 private:
  static std::vector<Vec3> positions(const std::vector<FieldPoint>& points) {
    std::vector<Vec3> at;
    at.reserve(points.size());
    for (const FieldPoint& point : points) at.push_back(point.at);
    return at;
  }

  template <class Body>
  void visit(std::size_t at, Body& body) {
    const PointTree::Node& node = tree_.nodes()[at];
    const double enough_mm = std::max(body.floor_mm(), kUnseen * static_cast<double>(least_[at]));
    if (body.most_mm(node, enough_mm) <= enough_mm) return;
    if (node.child != 0) {
      visit(node.child, body);
      visit(node.child + 1, body);
      least_[at] = std::min(least_[node.child], least_[node.child + 1]);
      return;
    }
    const std::size_t count = node.last - node.first;
    const LeafDepths found = body.depths(std::span(sorted_).subspan(node.first, count),
                                         std::span(std::as_const(depth_)).subspan(node.first, count));
    float least = std::numeric_limits<float>::max();
    for (std::size_t i = node.first; i < node.last; ++i) {
      depth_[i] = std::max(depth_[i], found[i - node.first]);
      least = std::min(least, depth_[i]);
    }
    least_[at] = least;
  }

  PointTree tree_;
  std::vector<FieldPoint> sorted_;  ///< in the tree's order
  std::vector<float> depth_;        ///< in the tree's order
  std::vector<float> least_;        ///< by node: the smallest depth below
};

}  // namespace gouge
