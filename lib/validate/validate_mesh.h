#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "lib/base/parallel.h"
#include "lib/mesh/indexed_mesh.h"
#include "lib/mesh/mesh_findings.h"

// The complete validation of a mesh: the counts of lib/mesh, and properties that must be exact. Double precision proves
// the properties where possible. Otherwise CGAL 5.5 (Polygon Mesh Processing) decides them, behind the interface
// cgal_bridge.h.

namespace gouge {

/// Pairs of triangles that have more in common than the vertices or the edge they share.
struct SelfIntersections {
  std::size_t pairs = 0;
  std::size_t first_triangle = 0;  ///< of the first pair: index in the file, from 0; the lower index of the two
  std::size_t second_triangle = 0;
  Vec3 position_mm = Vec3::Zero();  ///< a common point of the first pair; part coordinates
};

struct MeshValidation {
  MeshFindings findings;
  SelfIntersections self_intersections;
  bool has_triangles_without_area = false;  ///< exact, while findings.collinear_triangles allows for rounding
  /// Every piece faces the correct way for its nesting: outer shells outward, cavities inward, and so on. Nothing if
  /// the question has no meaning: the mesh is open, not manifold or intersects itself.
  std::optional<bool> bounds_volume;
  /// Signed volume, mm3; nothing in the same cases as for bounds_volume.
  std::optional<double> volume_mm3;
  /// The reason why the exact properties are undecided; empty if they are decided.
  std::string trouble;

  /// Returns whether the mesh is closed, manifold, consistently oriented outward, and free of self-intersections and
  /// duplicates.
  [[nodiscard]] bool is_sound() const;
  /// Returns the total number of defects of all kinds; 0 for a sound mesh without triangles of no area.
  [[nodiscard]] std::size_t defects() const;
};

/// Validates the mesh. `findings` are those of the same mesh (find_mesh_findings, or LoadedMesh::findings).
///
/// Ensures  The result is exact: no tolerance decides whether triangles intersect. Touching counts as intersecting.
///          Triangles of no area and repeated triangles are counted as such and are ignored for intersections.
/// Cost     O(n log n) for surfaces of real parts: about a microsecond and 100 bytes a triangle. The cost is ten times
///          higher if CGAL must decide whether the surface bounds a volume. That is so if a triangle has no area, or if
///          a piece may lie in another one.
/// Errors   None: a failure of CGAL is reported in `trouble`, and the mesh is then not sound.
[[nodiscard]] MeshValidation validate_mesh(const IndexedMesh& mesh, const MeshFindings& findings,
                                           const ProgressCall& progress = {});

}  // namespace gouge
