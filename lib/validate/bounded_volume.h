#pragma once

#include <cstddef>
#include <optional>

#include "lib/mesh/indexed_mesh.h"

namespace gouge::detail {

/// Returns whether a surface bounds a volume. A piece inside an even number of other pieces must face outward; a piece
/// inside an odd number must face inward. Returns nothing if rounding leaves open the facing of a piece or the number
/// of pieces around it.
///
/// Requires a closed, manifold, consistently oriented mesh that does not intersect itself, of triangles with area.
/// Ensures  The result is proved (docs/method/self_intersections.md, section 5).
/// Cost     O(n), and O(pieces^2) for pieces side by side in a slab across x. If the box of a piece is inside the box
///          of another: O(n log n) and 80 bytes a triangle.
[[nodiscard]] std::optional<bool> does_bound_volume(const IndexedMesh& mesh, std::size_t pieces);

/// Returns the sum of the signed volumes of the tetrahedra between the origin and each triangle, in the order of the
/// triangles.
[[nodiscard]] double signed_volume(const IndexedMesh& mesh);

}  // namespace gouge::detail
