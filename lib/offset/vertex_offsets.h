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

enum class NormalMethod {
  averaged,    ///< unit vector equiangular to the faces; where none exists, weighted by the faces' angles
  paraboloid,  ///< unit normal of the paraboloid through the neighbours (paraboloid.h)
  planes,      ///< the faces' planes are moved and meet again (plane_offset.h); longer than 1 at an edge
};

struct VertexOffset {
  Vec3 move = Vec3::Zero();            ///< zero at a vertex without a face
  PlaneCase planes = PlaneCase::none;  ///< what the faces' planes determine; also reported for the other methods
};

/// One for each vertex.
/// Cost    O(n).
/// Source  thesis 4.5.2.1 to 4.5.2.3. An equiangular vector exists when the moved planes meet in one point;
///         it is the direction of that point. The weights are the angles of the faces at the vertex: G.
///         Thuermer, C. Wuethrich, Computing vertex normals from polygonal facets, J. Graphics Tools 3
///         (1998).
[[nodiscard]] std::vector<VertexOffset> offset_vertices(const IndexedMesh& mesh, const MeshAdjacency& adjacency,
                                                        NormalMethod method);

/// Unit normal of every triangle; zero for one without area.
[[nodiscard]] std::vector<Vec3> face_normals(const IndexedMesh& mesh);

/// Sum of the faces' normals at a vertex, each weighted by its angle there; unit, or zero when they cancel.
[[nodiscard]] Vec3 angle_weighted_normal(const IndexedMesh& mesh, const MeshAdjacency& adjacency,
                                         const std::vector<Vec3>& normals, Corner vertex);

/// The depth at which triangle `triangle` of the offset has shrunk to a line or a point: the smallest d > 0
/// at which its normal turns over; infinity when it never does. The local part of the largest safe depth.
[[nodiscard]] double collapse_depth_mm(const IndexedMesh& mesh, const std::vector<VertexOffset>& offsets,
                                       std::size_t triangle);

}  // namespace gouge
