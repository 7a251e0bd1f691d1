#pragma once

#include "lib/hierarchy/block_tree.h"

namespace gouge {

/// Returns whether a triangle of the tree lies between a point and a viewer far away in direction `toward` (unit), farther than
/// `clear_mm` from the point. For pictures: in single precision, so what is met within rounding of its edge, or of
/// `clear_mm`, may be missed.
///
/// Cost     About O(log n); no allocation worth naming.
/// Source   slab-free traversal of wide nodes by their balls; triangles after Moeller and Trumbore 1997.
[[nodiscard]] bool is_hidden(const BlockTree& tree, const Vec3& point, const Vec3& toward, double clear_mm);

}  // namespace gouge
