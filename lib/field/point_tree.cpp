#include "lib/field/point_tree.h"

#include <algorithm>
#include <utility>

namespace gouge {
namespace {

constexpr std::size_t kBlocks = 64;

}  // namespace

void PointTree::split(std::size_t count) {
  const std::size_t block = std::max(count / kBlocks, kLeafPoints);
  nodes_.resize(1);
  nodes_[0].last = count;
  std::vector<bool> is_below_block{false};
  // The children of a node come after it, so one pass is enough: new nodes are appended.
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    const std::size_t first = nodes_[n].first, last = nodes_[n].last;
    const bool is_below = is_below_block[n];
    nodes_[n].is_block = !is_below && last - first <= block;
    if (last - first <= kLeafPoints) continue;
    const std::size_t middle = first + (last - first) / 2;
    nodes_[n].child = nodes_.size();
    const bool is_child_below = is_below || nodes_[n].is_block;
    for (const auto& [from, to] : {std::pair(first, middle), std::pair(middle, last)}) {
      Node& child = nodes_.emplace_back();
      child.first = from;
      child.last = to;
      is_below_block.push_back(is_child_below);
    }
  }
}

}  // namespace gouge
