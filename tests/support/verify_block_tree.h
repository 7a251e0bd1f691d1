#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "lib/hierarchy/block_tree.h"

namespace gouge::test {

class BlockTreeVerifier {
 public:
  explicit BlockTreeVerifier(const BlockTree& tree) : tree_(tree) {}

  std::vector<std::string> run() {
    std::size_t total = 0;
    for (const IndexedMesh* mesh : tree_.meshes) total += mesh->triangles.size();
    seen_.assign(total, 0);
    if (!tree_.nodes.empty()) visit_node(0);
    for (std::size_t t = 0; t < total; ++t) {
      if (seen_[t] != 1)
        broken_.push_back("triangle " + std::to_string(t) + " is in " + std::to_string(seen_[t]) + " leaves");
    }
    return std::move(broken_);
  }

 private:
  struct NodeRange {
    std::uint32_t node = 0;
    std::size_t lane = 0;
  };

  void visit_node(std::uint32_t index) {
    const NodeBlock& node = tree_.nodes[index];
    for (std::size_t i = 0; i < node.count; ++i) {
      above_.push_back({index, i});
      if (node.has_leaves) {
        visit_leaf(node.child[i]);
      } else {
        visit_node(node.child[i]);
      }
      above_.pop_back();
    }
  }

  void visit_leaf(std::uint32_t index) {
    const TriangleBlock& leaf = tree_.leaves[index];
    for (std::size_t i = 0; i < leaf.count; ++i) {
      ++seen_[leaf.triangle[i]];
      const std::array<Vec3, 3> corners = tree_.corners(leaf.triangle[i]);
      for (std::size_t c = 0; c < 3; ++c) {
        const Vec3 x = corners[c] - tree_.origin;
        const Vec3 rounded(leaf.corner[c][0][i], leaf.corner[c][1][i], leaf.corner[c][2][i]);
        if ((rounded - x).norm() > tree_.rounding_mm)
          broken_.push_back("a corner of triangle " + std::to_string(leaf.triangle[i]) + " is rounded too far");
        for (const NodeRange& a : above_) check(a, x, leaf.triangle[i]);
      }
    }
  }

  void check(const NodeRange& a, const Vec3& x, std::uint32_t triangle) {
    const NodeBlock& node = tree_.nodes[a.node];
    const Vec3 d = x - Vec3(node.center[0][a.lane], node.center[1][a.lane], node.center[2][a.lane]);
    const Vec3 normal(node.normal[0][a.lane], node.normal[1][a.lane], node.normal[2][a.lane]);
    const double height = normal.dot(d);
    const bool is_inside = d.norm() <= static_cast<double>(node.radius_mm[a.lane]) &&
                           std::abs(height) <= static_cast<double>(node.half_thickness_mm[a.lane]) &&
                           (d - height * normal).norm() <= static_cast<double>(node.disc_radius_mm[a.lane]);
    if (!is_inside)
      broken_.push_back("node " + std::to_string(a.node) + " does not hold triangle " + std::to_string(triangle));
  }

  const BlockTree& tree_;
  std::vector<std::uint32_t> seen_;
  std::vector<NodeRange> above_;
  std::vector<std::string> broken_;
};

/// Returns the broken invariants, one sentence each. The invariants: every triangle is in exactly one leaf, and every
/// bound holds.
[[nodiscard]] inline std::vector<std::string> verify_tree(const BlockTree& tree) {
  return BlockTreeVerifier(tree).run();
}

}  // namespace gouge::test
