#include "lib/validate/validate_mesh.h"

#include <utility>

#include "lib/validate/bounded_volume.h"
#include "lib/validate/cgal_bridge.h"
#include "lib/validate/self_intersections.h"

namespace gouge {
namespace {

MeshValidation not_decided(MeshValidation judged, const Diagnostic& why) {
  judged.trouble = why.message;
  return judged;
}

// Finds the volume. CGAL handles all cases but needs ten times the memory of the mesh, so it comes second.
Result<detail::VolumeFacts> find_volume(const IndexedMesh& mesh, std::size_t pieces, bool has_triangles_without_area) {
  if (!has_triangles_without_area) {
    if (const auto does_bound = detail::does_bound_volume(mesh, pieces))
      return detail::VolumeFacts{*does_bound, detail::signed_volume(mesh)};
  }
  return detail::find_volume_facts(mesh);
}

}  // namespace

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

MeshValidation validate_mesh(const IndexedMesh& mesh, const MeshFindings& findings, const ProgressCall& progress) {
  MeshValidation judged;
  judged.findings = findings;
  const auto without_area = detail::find_triangles_without_area(mesh);
  if (!without_area) return not_decided(std::move(judged), without_area.error());
  judged.has_triangles_without_area = !without_area->empty();
  const bool has_copies = findings.duplicate_triangles.count > 0;
  const Result<SelfIntersections> crossings =
      detail::find_self_intersections(mesh, *without_area, has_copies, progress);
  if (!crossings) return not_decided(std::move(judged), crossings.error());
  judged.self_intersections = *crossings;
  const bool has_meaning = findings.is_closed() && findings.is_manifold() && findings.is_consistently_oriented() &&
                           !has_copies && crossings->pairs == 0;
  if (!has_meaning) return judged;
  const Result<detail::VolumeFacts> facts = find_volume(mesh, findings.components, judged.has_triangles_without_area);
  if (!facts) return not_decided(std::move(judged), facts.error());
  judged.bounds_volume = facts->bounds_volume;
  judged.volume_mm3 = facts->volume_mm3;
  return judged;
}

}  // namespace gouge
