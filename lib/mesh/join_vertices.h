#pragma once

#include <cstddef>

#include "lib/base/result.h"
#include "lib/mesh/mesh_findings.h"

namespace gouge {

/// A mesh whose near vertices were joined, and what that took.
struct JoinedMesh {
  IndexedMesh mesh;
  MeshFindings findings;                ///< of `mesh`; its degenerate triangles are those that collapsed
  std::size_t vertices_joined = 0;      ///< vertices moved to the position of another
  double largest_shift_mm = 0;          ///< maximum distance moved
  std::size_t triangles_collapsed = 0;  ///< left with two corners at one point, and left out
};

/// Joins vertices no farther apart than `reach_mm`. Each goes to the nearest of the vertices before it that stay where
/// they are (of two as near to the earlier), or stays.
///
/// Requires reach_mm > 0 and what build_mesh ensures.
/// Ensures  No vertex moves farther than reach_mm, however long a chain of near vertices is. Those left are farther
///          apart than that. Deterministic. Triangles keep their order and their numbers in the file.
/// Errors   mesh-weld: every triangle collapses.
/// Cost     O(n).
[[nodiscard]] Result<JoinedMesh> join_near_vertices(const IndexedMesh& mesh, double reach_mm);

}  // namespace gouge
