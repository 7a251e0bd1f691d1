#pragma once

#include "lib/hierarchy/block_tree.h"

namespace gouge {

/// Returns whether a triangle of the tree hides a point from a distant viewer in direction `toward` (unit). The
/// triangle must be farther than `clear_mm` from the point. It is for pictures and in single precision. So a triangle
/// that is met within rounding of its edge, or of `clear_mm`, may be missed.
///
/// Cost     About O(log n); no significant allocation.
/// Source   Slab-free traversal of wide nodes by their balls; triangles after Moeller and Trumbore 1997.
[[nodiscard]] bool is_hidden(const BlockTree& tree, const Vec3& point, const Vec3& toward, double clear_mm);

}  // namespace gouge
