#pragma once

#include <vector>

#include "lib/mesh/indexed_mesh.h"
#include "lib/mesh/mesh_findings.h"
#include "lib/mesh/union_find.h"

namespace gouge::detail {

/// Adds to `found` what concerns pieces of surface: how many, volume and area, cavities and pieces inside
/// out. `pieces` joins the triangles of a piece; `is_open` says by a piece's lowest triangle whether its
/// edges are not all used equally often in both directions, and may be empty when none is. Requires
/// found.box_mm. Cost as described at find_mesh_findings.
void find_pieces(const IndexedMesh& mesh, UnionFind& pieces, const std::vector<bool>& is_open, MeshFindings& found);

}  // namespace gouge::detail
