#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lib/geom/vec.h"
#include "lib/mesh/adjacency.h"
#include "lib/mesh/indexed_mesh.h"

// Where the vertices of a triangulated surface go when the surface is offset (thesis 4.5.2). The offset at
// depth d has the same triangles over the vertices v - d * move; "inward" is against the triangles' normals.

namespace gouge {

/// The offset vertices that the planes at a vertex determine when each is moved along its normal.
enum class PlaneCase {
  none,          ///< no triangle with area: there is no plane
  one_plane,     ///< all faces coplanar: moves along their normal
  two_planes,    ///< a point of an edge: moves in the plane of both normals
  three_planes,  ///< one point fulfils all planes, three or more of them
  many_planes,   ///< more than three planes that no longer meet in a point: least squares
  knife,         ///< two planes fold back on each other: the offset runs away, cut at kLongestOffset
};

/// Maximum length of an offset vertex's run, in multiples of the offset.
inline constexpr double kLongestOffset = 20;

struct VertexOffset {
  Vec3 move = Vec3::Zero();            ///< n_i . move = 1 for every plane, as far as the case allows
  PlaneCase planes = PlaneCase::none;  ///< what the faces' planes determine; none: zero, where there is no face
};

/// Moves the planes through a vertex with unit `normals` by 1 and finds where they meet then. That is the shortest
/// solution of n_i . x = 1 in least squares.
/// Source  Thesis 4.5.2.3; the cases are those it calls degenerate.
[[nodiscard]] VertexOffset offset_of_planes(std::span<const Vec3> normals);

/// Returns the normals without repetitions (closer than 1e-9).
[[nodiscard]] std::vector<Vec3> distinct_normals(std::span<const Vec3> normals);

/// Returns one offset for each vertex: the planes of its faces are moved and meet again (offset_of_planes); longer than
/// 1 at an edge.
/// Cost    O(n).
/// Source  Thesis 4.5.2.3. Its two other methods are in tests/bench/penetration/normal_methods.h.
[[nodiscard]] std::vector<VertexOffset> offset_by_planes(const IndexedMesh& mesh, const MeshAdjacency& adjacency);

/// Returns the unit normal of every triangle; zero for one without area.
[[nodiscard]] std::vector<Vec3> face_normals(const IndexedMesh& mesh);

/// Returns the sum of the faces' normals at a vertex, each weighted by its angle there; unit, or zero when they cancel.
/// Source  G. Thuermer, C. Wuethrich, Computing vertex normals from polygonal facets, J. Graphics Tools 3 (1998).
[[nodiscard]] Vec3 angle_weighted_normal(const IndexedMesh& mesh, const MeshAdjacency& adjacency,
                                         const std::vector<Vec3>& normals, Corner vertex);

}  // namespace gouge
