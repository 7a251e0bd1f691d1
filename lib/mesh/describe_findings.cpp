#include "lib/base/number_text.h"
#include "lib/mesh/mesh_findings.h"

namespace gouge {
std::string position_text(const MeshSpot& spot, LengthUnit unit) {
  const int decimals = facts_of(unit).decimals;
  std::string text = "(";
  for (int k = 0; k < 3; ++k) {
    text += display_text(spot.position_mm[k] / mm_per(unit), decimals, Zeros::kept) + (k < 2 ? ", " : ") ");
  }
  return text + unit_name(unit) + ", triangle " + std::to_string(spot.file_triangle + 1);
}

Diagnostics describe(const MeshFindings& found, const std::string& file, LengthUnit unit) {
  Diagnostics reported;
  const auto report = [&](Severity severity, const char* code, const MeshSpot& spot, const std::string& one,
                          const std::string& many, const std::string& meaning) {
    if (spot.count == 0) return;
    const std::string where = std::string(spot.count == 1 ? " at " : ", the first at ") + position_text(spot, unit);
    reported.push_back({severity, code, file, 0, count_text(spot.count, one, many) + where + "; " + meaning});
  };
  report(Severity::warning, "mesh-open", found.boundary_edges, "open edge (one triangle only)",
         "open edges (one triangle only)",
         "the surface is checked, but a move that only this body could prove to be outside or inside is not certified: "
         "export a closed solid");
  report(Severity::warning, "mesh-misoriented", found.misoriented_edges,
         "edge with triangles oriented against each other", "edges with triangles oriented against each other",
         "the surface is checked, but a move that only this body could prove to be outside or inside is not certified: "
         "repair the mesh");
  report(Severity::warning, "mesh-inside-out", found.inside_out_components, "closed piece is inside out",
         "closed pieces are inside out", "inside and outside are exchanged there: repair the mesh");
  const bool is_cancelled = found.duplicate_triangles.count > 0;
  const bool is_harmless = found.is_watertight() && !is_cancelled;
  report(is_harmless ? Severity::note : Severity::warning, "mesh-non-manifold-edges", found.non_manifold_edges,
         "edge with more than two triangles", "edges with more than two triangles",
         is_harmless
             ? "the check is not affected"
             : "the surface is checked, but a tool wholly inside this body may be reported as not certified only");
  report(Severity::note, "mesh-non-manifold-vertices", found.non_manifold_vertices,
         "vertex where separate pieces of surface touch", "vertices where separate pieces of surface touch",
         "the check is not affected");
  report(Severity::warning, "mesh-duplicate-triangles", found.duplicate_triangles, "duplicated triangle",
         "duplicated triangles",
         "depths are not affected, but where the surface is doubled inside and outside cannot be determined: repair "
         "the mesh");
  report(Severity::note, "mesh-degenerate-triangles", found.degenerate_triangles,
         "triangle with identical corners left out", "triangles with identical corners left out", "they have no area");
  report(Severity::note, "mesh-collinear-triangles", found.collinear_triangles,
         "triangle without area (corners on one line)", "triangles without area (corners on one line)",
         "checked like the others");
  report(Severity::note, "mesh-opposite-normals", found.opposite_normals,
         "stored normal points to the other side of its triangle",
         "stored normals point to the other side of their triangles",
         "the order of the corners counts, normals are ignored");
  return reported;
}

}  // namespace gouge
