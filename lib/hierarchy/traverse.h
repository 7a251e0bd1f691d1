#pragma once

#include <bit>
#include <cstdint>
#include <optional>

#include "lib/hierarchy/block_tree.h"

namespace gouge {

/// The children of a node that a bit mask selects, in their order.
class MaskedLanes {
 public:
  explicit MaskedLanes(std::uint32_t mask) : mask_(mask) {}

  [[nodiscard]] std::optional<std::uint32_t> next() {
    if (mask_ == 0) return std::nullopt;
    const auto lane = static_cast<std::uint32_t>(std::countr_zero(mask_));
    mask_ &= mask_ - 1;
    return lane;
  }

 private:
  std::uint32_t mask_;
};

/// Visits a tree depth first. All walks that need no order across nodes share this loop; BestFirstSearch is for the
/// others. `Visitor` has:
///   auto children(const NodeBlock&)          A cursor. Its next() returns the next lane to enter, or none. It is
///   called
///                                            after the lane before was visited, so it may prune by the results there.
///   bool visit(const TriangleBlock&)         Returns true if the walk may end here.
/// Returns whether a visit ended the walk. Cost: the depth of the tree in stack frames, at most 16 for 2^32 triangles.
template <typename Visitor>
bool traverse(const BlockTree& tree, Visitor& visitor, std::uint32_t index = 0) {
  if (tree.nodes.empty()) return false;
  const NodeBlock& node = tree.nodes[index];
  auto children = visitor.children(node);
  while (const std::optional<std::uint32_t> lane = children.next()) {
    const std::uint32_t child = node.child[*lane];
    if (node.has_leaves ? visitor.visit(tree.leaves[child]) : traverse(tree, visitor, child)) return true;
  }
  return false;
}

}  // namespace gouge
