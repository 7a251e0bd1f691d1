#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "lib/geom/vec.h"
#include "lib/kdop/directions.h"
#include "lib/kdop/intervals.h"

// A tree of k-DOPs over numbered items, with two, four or eight children per node (thesis 5.2.1, 6.1.4.3). The caller
// defines the content of an item: facets with their offset, or points.

namespace gouge {

struct KdopNode {
  std::uint32_t first = 0;     ///< leaf: first slot in `order`; inner node: first child, followed by the other children
  std::uint16_t children = 0;  ///< 0: a leaf
  std::uint16_t level = 0;     ///< the root is 0
  std::uint32_t item_first = 0, item_count = 0;  ///< slots in `order` below this node
};

struct KdopTreeOptions {
  std::size_t width = 8;       ///< maximum number of children of an inner node: 2, 4 or 8
  std::size_t leaf_items = 1;  ///< maximum number of items of a leaf
};

struct KdopTree {
  DirectionSet directions;
  std::size_t stride = 0;            ///< see intervals.h
  std::vector<KdopNode> nodes;       ///< nodes[0] is the root; empty when there is no item
  std::vector<float> bounds;         ///< 2 * stride numbers for each node
  std::vector<std::uint32_t> order;  ///< items in leaf order

  [[nodiscard]] const float* bounds_of(std::size_t node) const { return bounds.data() + 2 * stride * node; }
  [[nodiscard]] float* bounds_of(std::size_t node) { return bounds.data() + 2 * stride * node; }
};

/// A function that writes the intervals of an item: 2 * stride numbers, unused slots included.
using BoundItem = std::function<void(std::uint32_t item, float* intervals)>;

/// Builds the tree. Splits at the median along the widest side of the box of the items' centres; items with equal
/// coordinates are sorted by number.
///
/// Requires width 2, 4 or 8; leaf_items >= 1; `bound` gives intervals that contain the item.
/// Ensures  The intervals of every node are the union of the intervals below it.
/// Cost     O(n log^2 n), deterministic.
[[nodiscard]] KdopTree build_kdop_tree(const DirectionSet& directions, std::span<const Vec3> centres,
                                       const KdopTreeOptions& options, const BoundItem& bound);

/// Writes the intervals of `points`, widened by the slack: `low - slack` and `high + slack`, in single precision. Fills
/// the unused slots.
void write_intervals(const DirectionSet& directions, std::span<const Vec3> points, double slack_mm, float* intervals);

}  // namespace gouge
