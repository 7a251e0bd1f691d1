#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "lib/base/parallel.h"
#include "lib/geom/vec.h"

namespace gouge {

/// A point of the surface, part coordinates.
struct FieldPoint {
  Vec3 at = Vec3::Zero();
  bool is_fixture = false;
};

/// Points of a surface in a tree of boxes, each with the largest depth told so far, so that a body at a place
/// visits only the points that it can reach deeper than that.
class PointTree {
 public:
  static constexpr std::size_t kLeafPoints = 16;
  static constexpr double kUnseen = 1.03;  ///< a depth not above this many times another looks the same
  using LeafDepths = std::array<float, kLeafPoints>;

  struct Node {
    Box3 box;
    Vec3 centre = Vec3::Zero();
    double radius = 0;  ///< of a ball about the box
    std::size_t first = 0, last = 0;
    std::size_t child = 0;  ///< of two neighbours; 0: a leaf
    float least = 0;        ///< smallest depth found below
  };

  explicit PointTree(const std::vector<FieldPoint>& points)
      : order_(points.size()), depth_(points.size(), 0.0F) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    if (points.empty()) return;
    nodes_.resize(1);
    fill(points, 0, 0, points.size(), std::max(points.size() / kBlocks, kLeafPoints), false);
    for (const std::size_t i : order_) sorted_.push_back(points[i]);
  }

  /// The largest depth that any place tells of each point, in mm, less 3 % at most; 0 where none does.
  ///
  /// A Place offers most_mm(node, enough_mm): no point of the node is deeper, as exact as it need be where
  /// that is not above `enough_mm`; depths(points of a leaf, told): of those deeper than told so far; and
  /// floor_mm(): what it tells is more. It may remember what it found: every block gets a copy of its own.
  template <class Place>
  [[nodiscard]] std::vector<float> answer(const std::vector<Place>& places) {
    // Blocks share no points, so they may be done in any order.
    for_each_chunk(blocks_.size(), 1, 0, [&](std::size_t first, std::size_t last) {
      for (std::size_t b = first; b < last; ++b) {
        for (Place place : places) visit(blocks_[b], place);
      }
    });
    std::vector<float> out(depth_.size());
    for (std::size_t i = 0; i < out.size(); ++i) out[order_[i]] = depth_[i];
    return out;
  }

 private:
  static constexpr std::size_t kBlocks = 64;

  void fill(const std::vector<FieldPoint>& points, std::size_t at, std::size_t first, std::size_t last,
            std::size_t block, bool is_in_block) {
    Box3 box;
    for (std::size_t i = first; i < last; ++i) box.extend(points[order_[i]].at);
    nodes_[at] = {box, box.center(), 0.5 * box.diagonal().norm(), first, last, 0, 0};
    if (!is_in_block && last - first <= block) {
      blocks_.push_back(at);
      is_in_block = true;
    }
    if (last - first <= kLeafPoints) return;
    int axis = 0;
    box.sizes().maxCoeff(&axis);
    const std::size_t middle = first + (last - first) / 2;
    const auto place = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(place(first), place(middle), place(last), [&](std::size_t a, std::size_t b) {
      const double xa = points[a].at[axis];
      const double xb = points[b].at[axis];
      return xa < xb || (!(xb < xa) && a < b);
    });
    const std::size_t child = nodes_.size();
    nodes_.resize(child + 2);
    nodes_[at].child = child;
    fill(points, child, first, middle, block, is_in_block);
    fill(points, child + 1, middle, last, block, is_in_block);
  }

  template <class Place>
  void visit(std::size_t at, Place& place) {
    Node& node = nodes_[at];
    const double enough_mm = std::max(place.floor_mm(), kUnseen * static_cast<double>(node.least));
    if (place.most_mm(node, enough_mm) <= enough_mm) return;
    if (node.child != 0) {
      visit(node.child, place);
      visit(node.child + 1, place);
      node.least = std::min(nodes_[node.child].least, nodes_[node.child + 1].least);
      return;
    }
    const std::size_t count = node.last - node.first;
    const LeafDepths told = place.depths(std::span(sorted_).subspan(node.first, count),
                                         std::span(std::as_const(depth_)).subspan(node.first, count));
    float least = std::numeric_limits<float>::max();
    for (std::size_t i = node.first; i < node.last; ++i) {
      depth_[i] = std::max(depth_[i], told[i - node.first]);
      least = std::min(least, depth_[i]);
    }
    node.least = least;
  }

  std::vector<FieldPoint> sorted_;  ///< leaf by leaf
  std::vector<std::size_t> order_;  ///< by place in `sorted_`: which it was
  std::vector<float> depth_;        ///< by place in `sorted_`
  std::vector<Node> nodes_;
  std::vector<std::size_t> blocks_;
};

}  // namespace gouge
