#pragma once

#include <optional>

#include "lib/hierarchy/block_tree.h"

namespace gouge {

/// How often closed surfaces wind around a point: the triangles that a ray from it leaves through, less those it enters
/// through. Nothing where the ray comes too near to an edge, or the point to a triangle, for rounding to tell.
/// Requires a unit direction. Cost about O(log n) and what the ray meets.
[[nodiscard]] std::optional<int> winding_along(const BlockTree& tree, const Vec3& point, const Vec3& direction);

}  // namespace gouge
