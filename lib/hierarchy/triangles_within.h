#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lib/geom/half_space.h"
#include "lib/hierarchy/block_tree.h"

namespace gouge {

/// Returns the triangles that reach into each half-space, and some that only come near: those of the leaves whose
/// bounds do. In increasing order.
///
/// Cost     O(log n) and the triangles found, which are sorted.
[[nodiscard]] std::vector<std::uint32_t> triangles_within(const BlockTree& tree, std::span<const HalfSpace> space);

/// Returns whether any triangle reaches into what all half-spaces have in common. Requires at most kMaxHalfSpaces.
///
/// Ensures  True where one does by more than 1e-9 mm, for coordinates up to 100 m.
/// Cost     O(log n) and the triangles near that space; no allocation worth naming.
[[nodiscard]] bool is_entered(const BlockTree& tree, std::span<const HalfSpace> space);

}  // namespace gouge
