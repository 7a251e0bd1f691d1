#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "lib/base/result.h"
#include "lib/mesh/indexed_mesh.h"
#include "lib/validate/repair_mesh.h"
#include "lib/validate/validate_mesh.h"

// The interface of cgal_self_intersections.cpp and cgal_repair.cpp, the only sources that include CGAL. CGAL's
// exceptions do not leave them: each function returns an error (code "cgal-failed") instead.

namespace gouge::detail {

/// Returns the elements of `triangles` whose corners lie on one line. Exact.
[[nodiscard]] Result<std::vector<std::uint32_t>> without_area(const IndexedMesh& mesh,
                                                              const std::vector<std::uint32_t>& triangles);

using TrianglePair = std::pair<std::uint32_t, std::uint32_t>;  ///< the lower triangle first

/// Returns the elements of `pairs` whose triangles have more in common than their shared corners. Exact. Requires
/// triangles with area.
[[nodiscard]] Result<std::vector<TrianglePair>> crossing_pairs(const IndexedMesh& mesh,
                                                               const std::vector<TrianglePair>& pairs);

/// Returns a common point of two crossing triangles, up to rounding.
[[nodiscard]] Result<Vec3> meeting_point(const IndexedMesh& mesh, const TrianglePair& pair);

struct VolumeFacts {
  bool bounds_volume = false;
  double volume_mm3 = 0;
};

/// Finds out whether the mesh bounds a volume, and its volume. Requires a closed, manifold, consistently oriented mesh
/// that does not intersect itself.
[[nodiscard]] Result<VolumeFacts> find_volume_facts(const IndexedMesh& mesh);

struct CgalRepair {
  IndexedMesh mesh;  ///< vertices that must stay apart may have identical coordinates
  RepairSteps steps;
};

/// Performs those steps of repair_mesh that use CGAL.
[[nodiscard]] Result<CgalRepair> repair_with_cgal(const IndexedMesh& mesh, bool fills_holes);

}  // namespace gouge::detail
