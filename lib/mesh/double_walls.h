#pragma once

#include <vector>

#include "lib/mesh/body_pieces.h"

namespace gouge {

/// Returns which pieces without open edges lie on themselves somewhere, so that they bound nothing there. Two triangles
/// of a piece, one over the other, cause that in three cases. (1) They cross, touch, or come nearer than 5e-5 of the
/// mesh's size, at less than 30 degrees. (2) They share an edge at less than 2 degrees. (3) In a pinched piece, they
/// share an edge at less than 45 degrees.
///
/// Ensures  The result has one flag for each triangle; only the flags of triangles that name a piece count.
/// Cost     O(n log n) for triangles that do not extend over most of the mesh.
[[nodiscard]] std::vector<bool> find_double_walls(const IndexedMesh& mesh, const SurfacePieces& pieces);

}  // namespace gouge
