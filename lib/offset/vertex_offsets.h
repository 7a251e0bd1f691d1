#pragma once

#include <cstdint>
#include <vector>

#include "lib/geom/vec.h"
#include "lib/mesh/adjacency.h"
#include "lib/mesh/indexed_mesh.h"
#include "lib/offset/plane_offset.h"

// Where the vertices of a triangulated surface go when the surface is offset (thesis 4.5.2). The offset at
// depth d has the same triangles over the vertices v - d * move; "inward" is against the triangles' normals.

namespace gouge {

struct VertexOffset {
  Vec3 move = Vec3::Zero();            ///< zero at a vertex without a face
  PlaneCase planes = PlaneCase::none;  ///< what the faces' planes determine
};

/// One for each vertex: the planes of its faces are moved and meet again (plane_offset.h); longer than 1 at an edge.
/// Cost    O(n).
/// Source  thesis 4.5.2.3. Its two other methods are in tests/bench/penetration/normal_methods.h.
[[nodiscard]] std::vector<VertexOffset> offset_by_planes(const IndexedMesh& mesh, const MeshAdjacency& adjacency);

/// Unit normal of every triangle; zero for one without area.
[[nodiscard]] std::vector<Vec3> face_normals(const IndexedMesh& mesh);

/// Sum of the faces' normals at a vertex, each weighted by its angle there; unit, or zero when they cancel.
/// Source  G. Thuermer, C. Wuethrich, Computing vertex normals from polygonal facets, J. Graphics Tools 3 (1998).
[[nodiscard]] Vec3 angle_weighted_normal(const IndexedMesh& mesh, const MeshAdjacency& adjacency,
                                         const std::vector<Vec3>& normals, Corner vertex);

}  // namespace gouge
