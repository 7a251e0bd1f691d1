#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lib/base/stage.h"
#include "lib/mesh/indexed_mesh.h"

// A short cut through what nearly every part is: a closed surface on which each edge has two triangles, one
// in either direction. A third of the time and half of the memory of a MeshAdjacency.

namespace gouge {

/// Half-edge 3 t + k runs from corner k of triangle t to its next corner. Its opposite runs back along the same edge.
using OppositeHalfEdges = std::vector<std::uint32_t>;

/// The opposite of every half-edge; nothing unless each edge is used exactly twice, once in either direction.
/// Nothing either for a mesh of more than 350 million triangles.
/// Cost     O(n); 12 bytes a triangle for the result, 20 more meanwhile. Three units of the stage a triangle.
[[nodiscard]] std::optional<OppositeHalfEdges> find_opposite_half_edges(const IndexedMesh& mesh,
                                                                        Stage* stage = nullptr);

/// Whether the triangles around every vertex form one fan, and no triangle has the corners of another. One unit of the
/// stage a triangle.
[[nodiscard]] bool is_manifold(const IndexedMesh& mesh, const OppositeHalfEdges& opposites, Stage* stage = nullptr);

}  // namespace gouge
