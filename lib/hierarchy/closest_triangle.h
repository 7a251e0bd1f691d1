#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "lib/geom/point_triangle.h"
#include "lib/hierarchy/block_tree.h"

namespace gouge {

/// The triangle of a tree nearest to a point.
struct ClosestTriangle {
  std::uint32_t triangle = 0;  ///< see BlockTree::corners
  TrianglePoint foot;          ///< on it; mm, part coordinates
};

/// Returns the nearest triangle within `within_mm` of a point, found from its exact corners; nothing when there is
/// none.
///
/// Ensures  The foot is that of closest_on_triangle, and no other triangle's has a smaller distance2_mm2; of those
///          whose distances are the same number, the lowest triangle. So it does not depend on the tree, nor on the
///          machine.
/// Requires coordinates of at most 1e9 mm.
/// Cost     About O(log n).
/// Proof    docs/method/closest_point.md.
[[nodiscard]] std::optional<ClosestTriangle> closest_triangle(
    const BlockTree& tree, const Vec3& point_part, double within_mm = std::numeric_limits<double>::infinity());

/// Returns the same without a limit, searched from a triangle of the tree: quicker where `near` is about as near as the
/// nearest.
[[nodiscard]] ClosestTriangle closest_triangle_from(const BlockTree& tree, const Vec3& point_part, std::uint32_t near);

}  // namespace gouge
