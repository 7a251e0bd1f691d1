#pragma once

#include "lib/mesh/indexed_mesh.h"
#include "lib/tool/convex_cover.h"

namespace gouge {

/// Builds solids of revolution about the z axis, one above the other, that contain a closed mesh. If a surface is free
/// of them, the mesh need not be examined. Each is the convex hull of the space that the mesh sweeps when it turns,
/// between two heights; it is rounded where the mesh is. It has the properties of CoverPiece, with the mesh as the tool
/// and r as the distance from the axis.
///
/// Ensures  The cover has no pieces if the mesh fills too little of them, for example a mesh beside the axis.
/// Cost     O(triangles); for each triangle also some of the heights at which the mesh may be cut.
/// Proof    docs/method/wide_sweep.md, section 7.
[[nodiscard]] ConvexCover make_revolved_cover(const IndexedMesh& mesh);

}  // namespace gouge
