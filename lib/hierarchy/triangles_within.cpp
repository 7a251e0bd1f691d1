#include "lib/hierarchy/triangles_within.h"

#include <algorithm>

namespace gouge {
namespace {

bool may_reach(const BlockTree& tree, const NodeBlock& node, std::size_t lane, std::span<const Slab> slabs) {
  const Vec3 centre =
      tree.origin + Vec3(static_cast<double>(node.center[0][lane]), static_cast<double>(node.center[1][lane]),
                         static_cast<double>(node.center[2][lane]));
  const double radius_mm = static_cast<double>(node.radius_mm[lane]) + tree.rounding_mm;
  return std::all_of(slabs.begin(), slabs.end(), [&](const Slab& slab) {
    const double height = slab.normal.dot(centre);
    return height + radius_mm >= slab.low_mm && height - radius_mm <= slab.high_mm;
  });
}

}  // namespace

std::vector<std::uint32_t> triangles_within(const BlockTree& tree, std::span<const Slab> slabs) {
  std::vector<std::uint32_t> found;
  std::vector<std::uint32_t> open(tree.nodes.empty() ? 0 : 1, 0);
  while (!open.empty()) {
    const NodeBlock& node = tree.nodes[open.back()];
    open.pop_back();
    for (std::size_t lane = 0; lane < node.count; ++lane) {
      if (!may_reach(tree, node, lane, slabs)) continue;
      if (!node.has_leaves) {
        open.push_back(node.child[lane]);
        continue;
      }
      const TriangleBlock& leaf = tree.leaves[node.child[lane]];
      for (std::size_t k = 0; k < leaf.count; ++k) found.push_back(leaf.triangle[k]);
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace gouge
