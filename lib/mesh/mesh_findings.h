#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "lib/base/diagnostic.h"
#include "lib/base/parallel.h"
#include "lib/base/units.h"
#include "lib/mesh/adjacency.h"
#include "lib/mesh/indexed_mesh.h"
#include "lib/mesh/mesh_builder.h"

// Facts about a mesh that can be counted: the part of validation that every check runs. Self-intersections need exact
// predicates; lib/validate finds them.

namespace gouge {

/// Findings with lengths in mm and part coordinates.
struct MeshFindings {
  std::size_t vertices = 0;    ///< V
  std::size_t edges = 0;       ///< E
  std::size_t triangles = 0;   ///< F
  std::size_t components = 0;  ///< number of pieces of surface connected through edges

  MeshSpot boundary_edges;         ///< edges with one triangle
  MeshSpot non_manifold_edges;     ///< edges with more than two triangles
  MeshSpot misoriented_edges;      ///< edges whose two triangles run along them in the same direction
  MeshSpot unbalanced_edges;       ///< edges not used equally often in both directions (including boundary and
                                   ///< misoriented edges)
  MeshSpot non_manifold_vertices;  ///< vertices where separate fans of triangles touch
  MeshSpot duplicate_triangles;    ///< triangles with the same corners as an earlier one, in any order
  MeshSpot inside_out_components;  ///< closed pieces that face inward and are not a cavity of another piece
  std::size_t cavities = 0;        ///< number of closed pieces that face inward inside another piece

  bool may_be_cut_off = false;  ///< the file is text without 'endsolid'

  MeshSpot degenerate_triangles;  ///< from build_mesh: left out of the mesh
  MeshSpot collinear_triangles;   ///< from build_mesh: kept in the mesh
  MeshSpot opposite_normals;      ///< from build_mesh

  double signed_volume_mm3 = 0;  ///< positive for an outward closed mesh; undefined unless is_watertight()
  double area_mm2 = 0;
  Box3 box_mm;

  [[nodiscard]] bool is_closed() const { return boundary_edges.count == 0; }
  [[nodiscard]] bool is_manifold() const { return non_manifold_edges.count == 0 && non_manifold_vertices.count == 0; }
  [[nodiscard]] bool is_consistently_oriented() const { return misoriented_edges.count == 0; }
  /// Returns whether the surface separates inside from outside, so that winding numbers are whole.
  [[nodiscard]] bool is_watertight() const { return unbalanced_edges.count == 0; }
  /// Returns whether inside is where the triangles state it, so that a buried tool is reported. With triangles written
  /// twice, there is no inside, or an inside that the nearest triangle does not show.
  [[nodiscard]] bool is_solid() const {
    return is_watertight() && inside_out_components.count == 0 && duplicate_triangles.count == 0;
  }

  /// Returns whether the volume is more than rounding. A sheet whose front and back are one closed surface has none.
  /// Requires is_watertight().
  [[nodiscard]] bool encloses_volume() const {
    constexpr double kThinnest_mm = 1e-6;
    return signed_volume_mm3 > kThinnest_mm * area_mm2;
  }

  /// Returns V - E + F: 2 for a surface like a sphere, 0 for one like a torus.
  [[nodiscard]] long long euler_number() const {
    return static_cast<long long>(vertices) - static_cast<long long>(edges) + static_cast<long long>(triangles);
  }
  /// Returns the number of handles (genus), summed over the components; nothing unless the mesh is closed and manifold.
  /// 0 for a single component means E = 3V - 6 and F = 2V - 4 (thesis 5.2).
  [[nodiscard]] std::optional<long long> handles() const;
};

/// Counts the findings. The result is deterministic: "first" is the lowest edge by vertex numbers, triangle by file
/// order, or vertex. Requires the guarantees of build_mesh.
/// Cost     O(n), plus O(n) for each of the first 64 pieces that face inward; later ones count as inside out.
[[nodiscard]] MeshFindings find_mesh_findings(const IndexedMesh& mesh, const ProgressCall& progress = {});
[[nodiscard]] MeshFindings find_mesh_findings(const IndexedMesh& mesh, const MeshAdjacency& adjacency);
[[nodiscard]] MeshFindings find_mesh_findings(const BuiltMesh& built, const ProgressCall& progress = {});

/// Returns one sentence for each kind of finding: the number, the place of the first, and the effect on a check. It is
/// a warning if a check can no longer detect a buried tool, otherwise a note. The result is empty for a clean solid.
/// Codes: mesh-open, mesh-misoriented, mesh-inside-out, mesh-non-manifold-edges, mesh-non-manifold-vertices,
/// mesh-duplicate-triangles, mesh-degenerate-triangles, mesh-collinear-triangles, mesh-opposite-normals.
[[nodiscard]] Diagnostics describe(const MeshFindings& findings, const std::string& file,
                                   LengthUnit unit = LengthUnit::mm);

/// Returns the place of a spot, as in "(1.000, 2.000, 3.000) mm, triangle 17". Triangles are counted from 1.
[[nodiscard]] std::string position_text(const MeshSpot& spot, LengthUnit unit);

}  // namespace gouge
