#pragma once

#include <cstddef>
#include <optional>

#include "lib/mesh/indexed_mesh.h"

namespace gouge::detail {

/// Returns whether a surface bounds a volume. Pieces that lie in an even number of others must face outward, those in
/// an odd number inward. Returns nothing where rounding leaves open which way one faces or in which others it lies.
///
/// Requires a closed, manifold, consistently oriented mesh that does not cross itself, of triangles with area.
/// Ensures  Proved (docs/method/self_intersections.md, section 5).
/// Cost     O(n), and O(pieces^2) for pieces side by side in a slab across x. Where a piece's box is in another's, O(n
///          log n) and 80 bytes a triangle.
[[nodiscard]] std::optional<bool> does_bound_volume(const IndexedMesh& mesh, std::size_t pieces);

/// Returns the sum of the signed volumes of the tetrahedra from the origin, in the order of the triangles.
[[nodiscard]] double signed_volume(const IndexedMesh& mesh);

}  // namespace gouge::detail
