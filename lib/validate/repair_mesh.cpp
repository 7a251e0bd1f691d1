#include "lib/validate/repair_mesh.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "lib/mesh/load_mesh.h"
#include "lib/mesh/write_stl.h"
#include "lib/validate/cgal_bridge.h"

namespace gouge {
namespace {

using Coordinates = std::array<float, 9>;

// Returns the coordinates of the corners, the lowest corner first, in cyclic order. They are equal for triangles with
// equal orientation.
Coordinates oriented(const IndexedMesh& mesh, const TriangleCorners& corners) {
  std::array<std::array<float, 3>, 3> points{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& v = mesh.vertices[corners[k]];
    points[k] = {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
  }
  std::rotate(points.begin(), std::min_element(points.begin(), points.end()), points.end());
  Coordinates all{};
  for (std::size_t k = 0; k < 9; ++k) all[k] = points[k / 3][k % 3];
  return all;
}

// Returns the number of triangles of `after` that `before` contains only with the opposite orientation.
std::size_t count_turned(const IndexedMesh& before, const IndexedMesh& after) {
  if (before.triangles == after.triangles && before.vertices == after.vertices) return 0;
  std::vector<Coordinates> known;
  known.reserve(before.triangles.size());
  for (const TriangleCorners& t : before.triangles) known.push_back(oriented(before, t));
  std::sort(known.begin(), known.end());
  const auto is_known = [&](const Coordinates& t) { return std::binary_search(known.begin(), known.end(), t); };
  std::size_t turned = 0;
  for (const TriangleCorners& t : after.triangles) {
    if (!is_known(oriented(after, t)) && is_known(oriented(after, {t[0], t[2], t[1]}))) ++turned;
  }
  return turned;
}

}  // namespace

Result<MeshRepair> repair_mesh(const IndexedMesh& mesh, const MeshValidation& before, const RepairOptions& options,
                               const ProgressCall& progress) {
  MeshRepair repair;
  repair.before = before;
  // In a sound mesh CGAL could only remove triangles without area.
  if (before.is_sound() && !before.has_triangles_without_area) {
    repair.stl_bytes = binary_stl_bytes(mesh, options.unit);
  } else {
    const Result<detail::CgalRepair> repaired = detail::repair_with_cgal(mesh, options.fills_holes);
    if (!repaired) {
      return make_error("mesh-repair-failed", "the mesh could not be repaired: " + repaired.error().message, mesh.name);
    }
    repair.steps = repaired->steps;
    repair.stl_bytes = binary_stl_bytes(repaired->mesh, options.unit);
  }
  repair.steps.degenerate_removed = before.findings.degenerate_triangles.count;
  Result<LoadedMesh> loaded = load_mesh_bytes(repair.stl_bytes, mesh.name, {options.unit, {}});
  if (!loaded) {
    return make_error("mesh-repair-failed", "nothing is left of the mesh after the repair", mesh.name);
  }
  repair.after = validate_mesh(loaded->mesh, loaded->findings, progress);
  repair.mesh = std::move(loaded->mesh);
  repair.steps.triangles_turned = count_turned(mesh, repair.mesh);
  return repair;
}

}  // namespace gouge
