#include "lib/hierarchy/triangles_within.h"

#include <algorithm>
#include <array>
#include <bit>

#include "lib/base/tolerance.h"
#include "lib/hierarchy/lane_space.h"

namespace gouge {
namespace {

/// Calls `visit(leaf)` for the leaves whose bounds reach into each half-space, until it returns true. Whether it did.
template <typename Visit>
bool visit_leaves(const BlockTree& tree, const LaneSpace& space, const Visit& visit) {
  std::vector<std::uint32_t> open(tree.nodes.empty() ? 0 : 1, 0);
  while (!open.empty()) {
    const NodeBlock& node = tree.nodes[open.back()];
    open.pop_back();
    for (std::uint32_t lanes = space.reached(node); lanes != 0; lanes &= lanes - 1) {
      const std::uint32_t child = node.child[static_cast<std::size_t>(std::countr_zero(lanes))];
      if (!node.has_leaves) {
        open.push_back(child);
      } else if (visit(tree.leaves[child])) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace

std::vector<std::uint32_t> triangles_within(const BlockTree& tree, std::span<const HalfSpace> space) {
  std::vector<std::uint32_t> found;
  visit_leaves(tree, LaneSpace(tree, space), [&](const TriangleBlock& leaf) {
    found.insert(found.end(), leaf.triangle.begin(), leaf.triangle.begin() + leaf.count);
    return false;
  });
  std::sort(found.begin(), found.end());
  return found;
}

bool is_entered(const BlockTree& tree, std::span<const HalfSpace> space) {
  std::array<HalfSpace, kMostHalfSpaces> wider;
  const std::size_t count = std::min(space.size(), wider.size());
  for (std::size_t i = 0; i < count; ++i) wider[i] = {space[i].direction, space[i].least_mm - Tolerance::kRounding_mm};
  const LaneSpace lane_space(tree, space);
  return visit_leaves(tree, lane_space, [&](const TriangleBlock& leaf) {
    for (std::uint32_t lanes = lane_space.reached(leaf); lanes != 0; lanes &= lanes - 1) {
      const std::uint32_t triangle = leaf.triangle[static_cast<std::size_t>(std::countr_zero(lanes))];
      if (is_any_within(tree.corners(triangle), {wider.data(), count})) return true;
    }
    return false;
  });
}

}  // namespace gouge
