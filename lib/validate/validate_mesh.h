#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "lib/base/parallel.h"
#include "lib/mesh/indexed_mesh.h"
#include "lib/mesh/mesh_findings.h"

// The whole judgement of a mesh: the counts of lib/mesh, and properties that must be exact. These are proved in double
// precision where that is possible. Else CGAL 5.5 (Polygon Mesh Processing) decides them, which stays behind
// cgal_bridge.h.

namespace gouge {

/// Pairs of triangles that have more in common than the vertices or the edge they share.
struct SelfIntersections {
  std::size_t pairs = 0;
  std::size_t first_triangle = 0;  ///< of the first pair: indices in the file from 0, the lower one first
  std::size_t second_triangle = 0;
  Vec3 position_mm = Vec3::Zero();  ///< a point where the first pair meets; part coordinates
};

struct MeshValidation {
  MeshFindings findings;
  SelfIntersections self_intersections;
  bool has_triangles_without_area = false;  ///< exact, where findings.collinear_triangles allows for rounding
  /// Every piece faces the right way for its nesting: outer shells outward, cavities inward, and so on.
  /// Nothing when the query has no meaning: open, not manifold or crossing itself.
  std::optional<bool> bounds_volume;
  /// Signed volume, mm3; nothing as above.
  std::optional<double> volume_mm3;
  /// The reason why the exact part was not decided; empty when it was.
  std::string trouble;

  /// Returns whether it is closed, manifold, consistently oriented outward, and free of self-intersections and
  /// duplicates.
  [[nodiscard]] bool is_sound() const;
  /// Returns the number of defects there are of all kinds together; 0 for a sound mesh without triangles of no area.
  [[nodiscard]] std::size_t defects() const;
};

/// Judges the mesh. `findings` are those of the same mesh (find_mesh_findings, or LoadedMesh::findings).
///
/// Ensures  Exact: no tolerance decides whether triangles intersect. Touching counts as intersecting.
///          Triangles of no area and repeated triangles are counted as such and take no part in
///          intersections.
/// Cost     O(n log n) for the surfaces of parts: about a microsecond and 100 bytes a triangle. Ten times that where
///          CGAL must state what the surface bounds: where a triangle has no area, or a piece may lie in another.
/// Errors   None: a failure of CGAL is reported in `trouble`, and the mesh is not sound then.
[[nodiscard]] MeshValidation validate_mesh(const IndexedMesh& mesh, const MeshFindings& findings,
                                           const ProgressCall& progress = {});

}  // namespace gouge
