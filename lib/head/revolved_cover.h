#pragma once

#include "lib/mesh/indexed_mesh.h"
#include "lib/tool/convex_cover.h"

namespace gouge {

/// Solids of revolution about the z axis, one above the other, that hold a closed mesh. A surface that they are free of
/// needs no examination of the mesh. Each is the convex hull of the space that the mesh turns through between two
/// heights, rounded where the mesh is. The claims of CoverPiece hold for it with the mesh as the tool, r being the
/// distance from the axis.
///
/// Ensures  Nothing is claimed (no pieces) of a mesh that fills too little of them, as one beside the axis.
/// Cost     O(triangles), and for each some of the heights at which the mesh may be cut.
/// Proof    docs/method/wide_sweep.md, section 7.
[[nodiscard]] ConvexCover make_revolved_cover(const IndexedMesh& mesh);

}  // namespace gouge
