#pragma once

#include "lib/base/result.h"
#include "lib/mesh/indexed_mesh.h"
#include "lib/validate/repair_mesh.h"
#include "lib/validate/validate_mesh.h"

// What cgal_self_intersections.cpp and cgal_repair.cpp, the only sources that include CGAL, offer to this module.
// Exceptions of CGAL end there: each function returns an error (code "cgal-failed") instead.

namespace gouge::detail {

/// Exact, whatever the mesh.
[[nodiscard]] Result<SelfIntersections> find_self_intersections(const IndexedMesh& mesh);

struct VolumeFacts {
  bool bounds_volume = false;
  double volume_mm3 = 0;
};

/// Requires a closed, manifold, consistently oriented mesh that does not cross itself.
[[nodiscard]] Result<VolumeFacts> find_volume_facts(const IndexedMesh& mesh);

struct CgalRepair {
  IndexedMesh mesh;  ///< vertices that must stay apart may have identical coordinates
  RepairSteps steps;
};

/// The steps of repair_mesh that are CGAL's.
[[nodiscard]] Result<CgalRepair> repair_with_cgal(const IndexedMesh& mesh, bool fills_holes);

}  // namespace gouge::detail
