#include "lib/hierarchy/triangles_within.h"

#include <algorithm>
#include <array>

#include "lib/hierarchy/lane_bound.h"

namespace gouge {
namespace {

constexpr double kRounding_mm = 1e-9;  // of a LaneBound and a few additions

bool may_reach(const LaneBound& bound, std::span<const HalfSpace> space) {
  return std::all_of(space.begin(), space.end(), [&](const HalfSpace& half) {
    return half.direction.dot(bound.center) + bound.extent_mm(half.direction) + kRounding_mm >= half.least_mm;
  });
}

/// Calls `visit(leaf)` for the leaves whose bounds reach into each half-space, until it returns true. Whether it did.
template <typename Visit>
bool visit_leaves(const BlockTree& tree, std::span<const HalfSpace> space, const Visit& visit) {
  std::vector<std::uint32_t> open(tree.nodes.empty() ? 0 : 1, 0);
  while (!open.empty()) {
    const NodeBlock& node = tree.nodes[open.back()];
    open.pop_back();
    for (std::size_t lane = 0; lane < node.count; ++lane) {
      if (!may_reach(LaneBound(tree, node, lane), space)) continue;
      if (!node.has_leaves) {
        open.push_back(node.child[lane]);
      } else if (visit(tree.leaves[node.child[lane]])) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace

std::vector<std::uint32_t> triangles_within(const BlockTree& tree, std::span<const HalfSpace> space) {
  std::vector<std::uint32_t> found;
  visit_leaves(tree, space, [&](const TriangleBlock& leaf) {
    found.insert(found.end(), leaf.triangle.begin(), leaf.triangle.begin() + leaf.count);
    return false;
  });
  std::sort(found.begin(), found.end());
  return found;
}

bool is_entered(const BlockTree& tree, std::span<const HalfSpace> space) {
  std::array<HalfSpace, kMostHalfSpaces> wider;
  const std::size_t count = std::min(space.size(), wider.size());
  for (std::size_t i = 0; i < count; ++i) wider[i] = {space[i].direction, space[i].least_mm - kRounding_mm};
  return visit_leaves(tree, space, [&](const TriangleBlock& leaf) {
    for (std::size_t k = 0; k < leaf.count; ++k) {
      if (is_any_within(tree.corners(leaf.triangle[k]), {wider.data(), count})) return true;
    }
    return false;
  });
}

}  // namespace gouge
