#pragma once

#include <cstdint>
#include <vector>

#include "lib/base/parallel.h"
#include "lib/base/result.h"
#include "lib/mesh/indexed_mesh.h"
#include "lib/validate/validate_mesh.h"

// Exact results at the speed of double precision. CGAL decides only the cases that the filters of triangle_filter.h
// cannot prove (docs/method/self_intersections.md).

namespace gouge::detail {

/// Returns the triangles whose corners lie on one line, in increasing order. Exact. Errors: cgal-failed.
[[nodiscard]] Result<std::vector<std::uint32_t>> find_triangles_without_area(const IndexedMesh& mesh);

/// Finds pairs of triangles that have more in common than their shared corners. Ignores triangles without area and
/// copies of earlier triangles (the same corners in any order). The result is exact and the same at any number of
/// threads.
///
/// Requires the result of find_triangles_without_area(mesh), and whether any triangle is a copy. Calls progress from
/// this thread.
/// Cost     O(n log n) for surfaces of real parts; 80 bytes a triangle.
/// Errors   cgal-failed.
[[nodiscard]] Result<SelfIntersections> find_self_intersections(const IndexedMesh& mesh,
                                                                const std::vector<std::uint32_t>& without_area,
                                                                bool has_copies, const ProgressCall& progress = {});

}  // namespace gouge::detail
