#pragma once

#include <span>
#include <vector>

#include "lib/geom/vec.h"
#include "lib/mesh/indexed_mesh.h"

namespace gouge {

/// Whether from one of `origins` a ray in one of `directions` meets no triangle, beyond doubt: what rounding could turn
/// into a hit counts as one.
///
/// Ensures  on true, one of the origins is joined with infinity by a straight line that keeps off the surface.
/// Requires directions that are not zero.
/// Cost     O(n) times the rays not yet known to be blocked; few remain after the first triangles where all are.
[[nodiscard]] bool has_free_ray(const IndexedMesh& mesh, std::span<const Vec3> origins,
                                std::span<const Vec3> directions);

}  // namespace gouge
