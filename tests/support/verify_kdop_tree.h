#pragma once

#include <string>
#include <vector>

#include "lib/kdop/kdop_tree.h"

namespace gouge::test {

inline void verify_children(const KdopTree& tree, std::size_t n, std::vector<std::string>& broken) {
  const KdopNode& node = tree.nodes[n];
  for (std::uint32_t k = 0; k < node.children; ++k) {
    const float* const outer = tree.bounds_of(n);
    const float* const inner = tree.bounds_of(node.first + k);
    bool is_inside = tree.nodes[node.first + k].level == node.level + 1;
    for (std::size_t i = 0; i < tree.stride; ++i) {
      is_inside = is_inside && outer[low_slot(i)] <= inner[low_slot(i)] && inner[high_slot(i)] <= outer[high_slot(i)];
    }
    if (!is_inside)
      broken.push_back("node " + std::to_string(node.first + k) + " leaves its parent " + std::to_string(n));
  }
}

/// Returns one line for every broken invariant: an item in no leaf or two, a child outside its parent.
[[nodiscard]] inline std::vector<std::string> verify_kdop_tree(const KdopTree& tree) {
  std::vector<std::string> broken;
  std::vector<std::uint32_t> seen(tree.order.size(), 0);
  for (std::size_t n = 0; n < tree.nodes.size(); ++n) {
    verify_children(tree, n, broken);
    const KdopNode& node = tree.nodes[n];
    for (std::uint32_t k = 0; node.children == 0 && k < node.item_count; ++k) ++seen[tree.order[node.first + k]];
  }
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (seen[i] != 1) broken.push_back("item " + std::to_string(i) + " is in " + std::to_string(seen[i]) + " leaves");
  }
  return broken;
}

}  // namespace gouge::test
