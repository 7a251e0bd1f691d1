#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lib/hierarchy/block_tree.h"

namespace gouge {

/// What is on the side of a plane that `direction` points to: direction . x >= least_mm, part coordinates.
struct HalfSpace {
  Vec3 direction = Vec3::UnitZ();  ///< unit
  double least_mm = 0;
};

/// The triangles that reach into each half-space, and some that only come near: those of the leaves whose bounds do. In
/// increasing order.
///
/// Cost     O(log n) and the triangles found, which are sorted.
[[nodiscard]] std::vector<std::uint32_t> triangles_within(const BlockTree& tree, std::span<const HalfSpace> space);

/// Whether any triangle reaches into what all half-spaces have in common. Requires at most 12 of them.
///
/// Ensures  true where one does by more than 1e-9 mm, for coordinates up to 100 m.
/// Cost     O(log n) and the triangles near that space; no allocation worth naming.
[[nodiscard]] bool is_entered(const BlockTree& tree, std::span<const HalfSpace> space);

}  // namespace gouge
