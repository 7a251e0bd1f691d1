#pragma once

#include <optional>

#include "lib/hierarchy/block_tree.h"
#include "lib/mesh/indexed_mesh.h"
#include "lib/mesh/vertex_triangles.h"

namespace gouge {

/// Part of a closed surface that separates points that it winds around from points that it does not.
struct SolidBoundary {
  /// Each triangle is one of the surface or a part of one, turned so that it faces outward; file_triangle as there.
  IndexedMesh mesh;
  /// Parts of triangles, or triangles that touch others: edges do not show what is adjacent.
  bool is_cut = false;
  /// False where rounding leaves the sides of some part of the surface unknown; then `mesh` is empty.
  bool is_known = true;
};

/// Finds the boundary of the body; nothing where the surface itself is that boundary.
///
/// A point is in the body where the winding number is not 0. Where shells nest, overlap or cross, a part of the surface
/// has nonzero winding numbers on both sides. It lies inside the body, and is left out.
/// Requires a closed, oriented surface; `tree` and `around` of that mesh alone.
/// Ensures  No point of the boundary is farther than rounding from the triangles, and none of theirs from the boundary.
/// Cost     About a microsecond a triangle where none meet. For each triangle that meets k others also O(k log k).
/// Proof    docs/method/inside_outside.md, section 6.
[[nodiscard]] std::optional<SolidBoundary> find_solid_boundary(const IndexedMesh& mesh, const BlockTree& tree,
                                                               const VertexTriangles& around, unsigned threads = 0);

}  // namespace gouge
