#pragma once

#include <vector>

#include "lib/offset/vertex_offsets.h"

// The thesis's other two ways to offset a vertex, for its tables: no program uses them.

namespace gouge {

/// The unit vector equiangular to the faces; where none exists, their normals weighted by angle.
/// Source  thesis 4.5.2.1. An equiangular vector exists when the moved planes meet in one point; it is the direction of
///         that point.
[[nodiscard]] std::vector<VertexOffset> offset_averaged(const IndexedMesh& mesh, const MeshAdjacency& adjacency);

/// The unit normal of the paraboloid through the neighbours (paraboloid.h).
/// Source  thesis 4.5.2.2
[[nodiscard]] std::vector<VertexOffset> offset_by_paraboloid(const IndexedMesh& mesh, const MeshAdjacency& adjacency);

/// The depth at which triangle `triangle` of the offset has shrunk to a line or a point: the smallest d > 0
/// at which its normal turns over; infinity when it never does. The local part of the largest safe depth.
[[nodiscard]] double collapse_depth_mm(const IndexedMesh& mesh, const std::vector<VertexOffset>& offsets,
                                       std::size_t triangle);

}  // namespace gouge
