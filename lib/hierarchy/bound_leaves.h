#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "lib/geom/vec.h"
#include "lib/hierarchy/blocks.h"

// Bounds of whole leaves, sixteen triangles at a time. They use the processor's instructions and give the same bytes
// with any of them.

namespace gouge::detail {

/// Returns the sum of the directions of a leaf's triangles, each with twice its area as length.
[[nodiscard]] std::array<float, 3> area_sum(const TriangleBlock& leaf);

/// Writes the bounds of all `leaves` into lane `lane` of a node: an oriented disc and a ball. The disc is about
/// `direction`, which may have any length; if it is zero, the disc is about the z axis. A corner may be up to
/// `rounding_mm` from its stored position. The written bounds include that, and the rounding of the arithmetic here.
void bound_leaves(std::span<const TriangleBlock> leaves, const Vec3& direction, double rounding_mm, NodeBlock& node,
                  std::size_t lane);

/// The reach of each triangle along three directions and against them, without a margin for rounding.
struct LeafExtent {
  std::array<Lanes, 3> high, low;
};
[[nodiscard]] LeafExtent extent_of(const TriangleBlock& leaf, const std::array<Vec3, 3>& directions);

}  // namespace gouge::detail
