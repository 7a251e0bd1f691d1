#pragma once

#include <cstddef>
#include <optional>

#include "lib/mesh/indexed_mesh.h"

namespace gouge::detail {

/// Whether all pieces of a surface face outward, where that decides whether it bounds a volume: no piece can lie in
/// another, as none has its box in another's. Nothing where one may, or where rounding leaves open which way one faces.
///
/// Requires a closed, manifold, consistently oriented mesh that does not cross itself, of triangles with area.
/// Ensures  proved: the sign of the volume of each piece, summed from the middle of the mesh, is beyond the error of
///          the sum. An embedded closed surface faces outward just where that is positive.
/// Cost     O(n), and O(pieces^2) for pieces that lie side by side in a slab across x.
[[nodiscard]] std::optional<bool> face_all_pieces_outward(const IndexedMesh& mesh, std::size_t pieces);

/// Sum of the signed volumes of the tetrahedra from the origin, in the order of the triangles.
[[nodiscard]] double signed_volume(const IndexedMesh& mesh);

}  // namespace gouge::detail
