#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lib/geom/vec.h"
#include "lib/mesh/adjacency.h"
#include "lib/mesh/indexed_mesh.h"

// The motion of the vertices of a triangulated surface when the surface is offset (thesis 4.5.2). The offset at depth d
// has the same triangles over the vertices v - d * move; "inward" is against the triangles' normals.

namespace gouge {

/// Cases of the offset vertex that the planes at a vertex determine when each plane is moved along its normal.
enum class PlaneCase {
  none,          ///< no triangle has area, so there is no plane
  one_plane,     ///< all faces are coplanar; the vertex moves along their normal
  two_planes,    ///< the vertex is on an edge; it moves in the plane of both normals
  three_planes,  ///< three or more planes that meet in one point
  many_planes,   ///< more than three planes that do not meet in a point after the move: least squares
  knife,         ///< two planes fold back on each other; the move would be endless and is cut at kLongestOffset
};

/// Maximum length of a vertex's move, in multiples of the offset.
inline constexpr double kLongestOffset = 20;

struct VertexOffset {
  Vec3 move = Vec3::Zero();            ///< n_i . move = 1 for every plane, as far as the case allows
  PlaneCase planes = PlaneCase::none;  ///< case of the planes; for `none` the move is zero
};

/// Moves the planes through a vertex with unit `normals` by 1, and finds the point at which they then meet. It is the
/// shortest solution of n_i . x = 1 in least squares.
/// Source  Thesis 4.5.2.3; the cases are those that the thesis calls degenerate.
[[nodiscard]] VertexOffset offset_of_planes(std::span<const Vec3> normals);

/// Returns the normals without repetitions (closer than 1e-9).
[[nodiscard]] std::vector<Vec3> distinct_normals(std::span<const Vec3> normals);

/// Returns one offset for each vertex, at which the moved planes of its faces meet again (offset_of_planes). It is
/// longer than 1 at an edge.
/// Cost    O(n).
/// Source  Thesis 4.5.2.3. Its two other methods are in tests/bench/penetration/normal_methods.h.
[[nodiscard]] std::vector<VertexOffset> offset_by_planes(const IndexedMesh& mesh, const MeshAdjacency& adjacency);

/// Returns the unit normal of every triangle; zero for one without area.
[[nodiscard]] std::vector<Vec3> face_normals(const IndexedMesh& mesh);

/// Returns the sum of the normals of a vertex's faces, each weighted by its angle there. The result is a unit vector,
/// or zero if the normals cancel.
/// Source  G. Thuermer, C. Wuethrich, Computing vertex normals from polygonal facets, J. Graphics Tools 3 (1998).
[[nodiscard]] Vec3 angle_weighted_normal(const IndexedMesh& mesh, const MeshAdjacency& adjacency,
                                         const std::vector<Vec3>& normals, Corner vertex);

}  // namespace gouge
