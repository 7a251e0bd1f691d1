#pragma once

#include <cstddef>

#include "lib/base/result.h"
#include "lib/mesh/mesh_findings.h"

namespace gouge {

/// A mesh whose near vertices were joined, with the changes that this made.
struct JoinedMesh {
  IndexedMesh mesh;
  MeshFindings findings;                ///< findings of `mesh`; its degenerate triangles are those that collapsed
  std::size_t vertices_joined = 0;      ///< number of vertices moved to the position of another
  double largest_shift_mm = 0;          ///< maximum distance that a vertex moved
  std::size_t triangles_collapsed = 0;  ///< number of triangles with two corners at one point, which were left out
};

/// Joins vertices that are at most `reach_mm` apart. Each vertex moves to the nearest earlier vertex that stays; if two
/// are equally near, to the earlier one. If there is none within reach, it stays.
///
/// Requires reach_mm > 0 and the guarantees of build_mesh.
/// Ensures  No vertex moves farther than reach_mm, even in a long chain of near vertices. The remaining vertices are
///          farther apart than that. The result is deterministic. Triangles keep their order and their numbers in the
///          file.
/// Errors   mesh-weld: every triangle collapses.
/// Cost     O(n).
[[nodiscard]] Result<JoinedMesh> join_near_vertices(const IndexedMesh& mesh, double reach_mm);

}  // namespace gouge
