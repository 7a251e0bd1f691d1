#include "lib/validate/validate_mesh.h"

#include "lib/validate/cgal_bridge.h"
#include "lib/validate/self_intersections.h"

namespace gouge {

bool MeshValidation::is_sound() const {
  return trouble.empty() && findings.is_closed() && findings.is_manifold() && findings.is_consistently_oriented() &&
         findings.is_solid() && findings.duplicate_triangles.count == 0 && self_intersections.pairs == 0 &&
         bounds_volume.value_or(false);
}

std::size_t MeshValidation::defects() const {
  const std::size_t is_misnested = bounds_volume.value_or(true) ? 0 : 1;
  return findings.boundary_edges.count + findings.non_manifold_edges.count + findings.misoriented_edges.count +
         findings.non_manifold_vertices.count + findings.duplicate_triangles.count +
         findings.inside_out_components.count + findings.degenerate_triangles.count +
         findings.collinear_triangles.count + self_intersections.pairs + is_misnested;
}

MeshValidation validate_mesh(const IndexedMesh& mesh, const MeshFindings& findings) {
  MeshValidation judged;
  judged.findings = findings;
  const auto without_area = detail::find_triangles_without_area(mesh);
  if (!without_area) {
    judged.trouble = without_area.error().message;
    return judged;
  }
  const Result<SelfIntersections> crossings =
      detail::find_self_intersections(mesh, *without_area, findings.duplicate_triangles.count > 0);
  if (!crossings) {
    judged.trouble = crossings.error().message;
    return judged;
  }
  judged.self_intersections = *crossings;
  const bool has_meaning = findings.is_closed() && findings.is_manifold() && findings.is_consistently_oriented() &&
                           findings.duplicate_triangles.count == 0 && crossings->pairs == 0;
  if (!has_meaning) return judged;
  const Result<detail::VolumeFacts> facts = detail::find_volume_facts(mesh);
  if (!facts) {
    judged.trouble = facts.error().message;
    return judged;
  }
  judged.bounds_volume = facts->bounds_volume;
  judged.volume_mm3 = facts->volume_mm3;
  return judged;
}

}  // namespace gouge
