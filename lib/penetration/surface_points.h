#pragma once

#include <vector>

#include "lib/mesh/indexed_mesh.h"

namespace gouge {

/// Points of a surface, none of whose points is farther than `spacing_mm` from one of them.
///
/// The depth below another surface changes by no more than the distance moved. So what a moving body's points
/// show holds for all of its surface up to the spacing: nothing deeper than the largest reported depth plus the
/// spacing is inside, and nothing that reaches deeper than the spacing is missed, be it between vertices, on
/// an edge or amid a face that a spike pierces.
///
/// Shape    the mesh's vertices first, in order; then the inner points of a grid over each triangle that is
/// wide. Requires spacing_mm > 0.
/// Cost     about area / spacing^2 points.
/// Source   beyond thesis 4.2, which takes the vertices alone; covering of a triangle by its corners: none of its
///          points is farther from the nearest corner than the longest edge over the square root of 3.
[[nodiscard]] std::vector<Vec3> surface_points(const IndexedMesh& mesh, double spacing_mm);

}  // namespace gouge
