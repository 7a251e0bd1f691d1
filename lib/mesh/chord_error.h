#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lib/mesh/indexed_mesh.h"

namespace gouge {

/// Estimates at some triangles how far the facets of the mesh stand out of the curved surface that they replace. On a hollow
/// surface facets lie on the side of the tool, so that a tool on the true surface cuts into them.
///
/// A facet of height h, measured from an edge, that meets its neighbour of height k there at a hollow angle a replaces an
/// arc of radius (h + k) / 2a, which is at most h h a / (4 (h + k)) away from it. An edge with an angle above 30 degrees
/// is taken for an edge of the part.
///
/// Returns   For each of `file_triangles`, indices of triangles in their file, the largest estimate at its edges in mm, 0
///           where all neighbours are flat or bulge.
/// Cost      One pass over the mesh.
[[nodiscard]] std::vector<double> estimate_chord_errors_mm(const IndexedMesh& mesh,
                                                           std::span<const std::uint32_t> file_triangles);

}  // namespace gouge
