#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "lib/mesh/indexed_mesh.h"
#include "lib/tool/tool_variants.h"

namespace gouge {

/// An obstacle of a scene: its row of the contact table.
enum class Against : std::uint8_t { part, fixture };

/// Limits of one mesh, stricter than those of the check.
struct MeshLimit {
  Against against = Against::fixture;
  std::size_t mesh = 0;  ///< index into the meshes of that obstacle
  /// Minimum distance of the bare tool and of the heads, mm. Requires 0 on a workpiece, which cutters touch.
  double clearance_mm = 0;
  /// Maximum depth in the tool, or, where there is a clearance, of the surface within it, mm. A larger tolerance than
  /// that of the check changes nothing.
  double tolerance_mm = 0;
};

/// The stationary objects: parts and fixtures, in mm and part coordinates.
struct Scene {
  std::vector<IndexedMesh> parts;
  std::vector<IndexedMesh> fixtures;
  std::vector<MeshLimit> limits{};  ///< of some of the meshes, at most one a mesh
};

}  // namespace gouge
