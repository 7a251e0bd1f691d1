#pragma once

#include <optional>

#include "lib/hierarchy/block_tree.h"
#include "lib/mesh/indexed_mesh.h"
#include "lib/mesh/vertex_triangles.h"

namespace gouge {

/// The part of a closed surface that separates points around which it winds from all other points.
struct SolidBoundary {
  /// Each triangle is one of the surface or a part of one, turned so that it faces outward. file_triangle is that of
  /// the surface.
  IndexedMesh mesh;
  /// True if there are parts of triangles, or triangles that touch others: then edges do not show adjacency.
  bool is_cut = false;
  /// False if, because of rounding, the sides of some part of the surface are unknown; then `mesh` is empty.
  bool is_known = true;
};

/// Finds the boundary of the body; nothing if the surface itself is that boundary.
///
/// A point is in the body if the winding number is not 0. Where shells nest, overlap or cross, a part of the surface
/// has nonzero winding numbers on both sides. That part lies inside the body and is left out.
/// Requires a closed, oriented surface; `tree` and `around` are those of this mesh alone.
/// Ensures  Apart from rounding, the boundary consists of points of the surface's triangles, and has all of those that
///          separate inside from outside.
/// Cost     About a microsecond for each triangle if none meet. For each triangle that meets k others also O(k log k).
/// Proof    docs/method/inside_outside.md, section 6.
[[nodiscard]] std::optional<SolidBoundary> find_solid_boundary(const IndexedMesh& mesh, const BlockTree& tree,
                                                               const VertexTriangles& around, unsigned threads = 0);

}  // namespace gouge
