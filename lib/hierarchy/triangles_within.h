#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lib/hierarchy/block_tree.h"

namespace gouge {

/// The space between two parallel planes: low_mm <= normal . x <= high_mm, part coordinates.
struct Slab {
  Vec3 normal = Vec3::UnitZ();  ///< unit
  double low_mm = 0, high_mm = 0;
};

/// The triangles that reach into all slabs, and some that only come near: those of the leaves whose balls do. In
/// increasing order.
///
/// Cost     O(log n) and the triangles found, which are sorted.
[[nodiscard]] std::vector<std::uint32_t> triangles_within(const BlockTree& tree, std::span<const Slab> slabs);

}  // namespace gouge
