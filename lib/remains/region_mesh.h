#pragma once

#include <string>

#include "lib/base/result.h"
#include "lib/mesh/indexed_mesh.h"
#include "lib/remains/proved_region.h"

namespace gouge {

/// The sides of a region that a mesh may bound.
enum class MeshOf : std::uint8_t { region, rest };

/// Returns the surface of a region as a closed mesh, outward for the region or for the rest of space.
///
/// Ensures  The triangles meet only at common edges and vertices. An edge has two triangles.
/// Errors   stock-mesh-failed: the surface is not closed.
/// Source   Every cell is divided into tetrahedra of an edge, a point of a face and a point in the cell, as in Ju and
///          Udeshi, Intersection-free contouring on an octree grid (2006). Proof: docs/method/stock_meshes.md.
[[nodiscard]] Result<IndexedMesh> mesh_of(const ProvedRegion& region, MeshOf side);

}  // namespace gouge
