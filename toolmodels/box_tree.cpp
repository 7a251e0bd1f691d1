#include "toolmodels/box_tree.h"

#include <bit>
#include <numbers>

namespace gouge::detail {

Eigen::AlignedBox2d box_around(const ProfileElement& e, double margin_mm) {
  Eigen::AlignedBox2d box(e.a);
  box.extend(e.b);
  if (e.is_arc && sweep_rad(e) < std::numbers::pi) {
    // The arc lies within the rectangle over its chord that has the height of the arc.
    const Vec2 rise = sample(e, 2)[1] - 0.5 * (e.a + e.b);
    box.extend(Vec2(e.a + rise));
    box.extend(Vec2(e.b + rise));
  } else if (e.is_arc) {
    box.extend(Vec2(e.center.array() - e.radius_mm));
    box.extend(Vec2(e.center.array() + e.radius_mm));
  }
  return {Vec2(box.min().array() - margin_mm), Vec2(box.max().array() + margin_mm)};
}

BoxTree::BoxTree(const std::vector<Eigen::AlignedBox2d>& boxes)
    : leaf_count_(std::bit_ceil(boxes.size())), nodes_(2 * leaf_count_) {
  for (std::size_t i = 0; i < boxes.size(); ++i) nodes_[leaf_count_ + i] = boxes[i];
  for (std::size_t node = leaf_count_ - 1; node > 0; --node)
    nodes_[node] = nodes_[2 * node].merged(nodes_[2 * node + 1]);
}

}  // namespace gouge::detail
