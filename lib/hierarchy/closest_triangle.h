#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "lib/geom/point_triangle.h"
#include "lib/hierarchy/block_tree.h"

namespace gouge {

/// The triangle of a tree that is nearest to a point.
struct ClosestTriangle {
  std::uint32_t triangle = 0;  ///< index for BlockTree::corners
  TrianglePoint foot;          ///< the closest point of the triangle; mm, part coordinates
};

/// Returns the nearest triangle within `within_mm` of a point, computed from its exact corners; nothing if there is
/// none.
///
/// Ensures  The foot is that of closest_on_triangle, and no other triangle has a smaller distance2_mm2. Among triangles
///          with exactly the same distance it is the one with the lowest number. So the result does not depend on the
///          tree or on the machine.
/// Requires coordinates of at most 1e9 mm.
/// Cost     About O(log n).
/// Proof    docs/method/closest_point.md.
[[nodiscard]] std::optional<ClosestTriangle> closest_triangle(
    const BlockTree& tree, const Vec3& point_part, double within_mm = std::numeric_limits<double>::infinity());

/// Returns the same without a limit. The search starts from triangle `near` of the tree, which is faster if that is
/// about as near as the nearest.
[[nodiscard]] ClosestTriangle closest_triangle_from(const BlockTree& tree, const Vec3& point_part, std::uint32_t near);

}  // namespace gouge
