#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "lib/mesh/indexed_mesh.h"
#include "lib/tool/tool_variants.h"

namespace gouge {

/// Counterparts of a tool, each a row of the contact table: the obstacles of a scene, then the stock, which is no mesh of the
/// scene (lib/stock).
enum class Against : std::uint8_t { part, fixture, stock };

/// Limits of one mesh that are stricter than those of the check.
struct MeshLimit {
  Against against = Against::fixture;
  std::size_t mesh = 0;  ///< index into the meshes of that obstacle
  /// Minimum distance of the mesh from the tool without offsets and from the heads, mm. Requires 0 on a workpiece,
  /// which cutters touch.
  double clearance_mm = 0;
  /// Maximum depth of the mesh in the tool, mm; with a clearance, maximum depth within the clearance. A tolerance above
  /// that of the check has no effect.
  double tolerance_mm = 0;
};

/// The stationary objects, parts and fixtures, in mm and part coordinates.
struct Scene {
  std::vector<IndexedMesh> parts;
  std::vector<IndexedMesh> fixtures;
  std::vector<MeshLimit> limits{};  ///< limits of some meshes, at most one for each mesh
};

}  // namespace gouge
