#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lib/geom/half_space.h"
#include "lib/hierarchy/block_tree.h"

namespace gouge {

/// Returns the triangles that reach into each half-space, in increasing order. The result also has some that only come
/// near: all triangles of the leaves whose bounds reach into each half-space.
///
/// Cost     O(log n) plus the number of found triangles, which are sorted.
[[nodiscard]] std::vector<std::uint32_t> triangles_within(const BlockTree& tree, std::span<const HalfSpace> space);

/// Returns whether any triangle reaches into the intersection of the half-spaces. Requires at most kMaxHalfSpaces.
///
/// Ensures  It is true if a triangle reaches in by more than 1e-9 mm, for coordinates up to 100 m.
/// Cost     O(log n) plus the number of triangles near that space; no significant allocation.
[[nodiscard]] bool is_entered(const BlockTree& tree, std::span<const HalfSpace> space);

/// Returns the maximum of direction . x over the corners x of all triangles, or `low_mm` if that is larger. Infinite as soon as a
/// corner above `high_mm` is found. Requires a unit vector.
///
/// Ensures  It misses at most 1e-9 mm, for coordinates up to 100 m.
/// Cost     O(log n) plus the number of triangles near or above `low_mm`, or fewer if one is above `high_mm`.
[[nodiscard]] double highest_along(const BlockTree& tree, const Vec3& direction, double low_mm, double high_mm);

}  // namespace gouge
