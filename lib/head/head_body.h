#pragma once

#include <string>
#include <vector>

#include "lib/base/result.h"
#include "lib/head/support_planes.h"
#include "lib/mesh/mesh_findings.h"
#include "lib/surface/surface.h"
#include "lib/tool/convex_cover.h"

namespace gouge {

/// A machine head, angle head, probe or clamp that moves with the tool, in the tool's frame.
struct HeadBody {
  Surface surface;
  Box3 box;
  /// For each piece of its surface a point inside it, the deepest of some hundred tries, and how deep it is.
  std::vector<Vec3> cores;
  std::vector<double> core_depths_mm;
  ConvexCover cover;       ///< make_revolved_cover of its surface
  SupportPlanes supports;  ///< of its surface
};

/// Requires what build_mesh ensures, and a surface that does not cross itself: the nearest facet decides the
/// side.
/// Errors   mesh-head-open: the surface is not closed, so what is inside it is not defined.
[[nodiscard]] Result<HeadBody> build_head_body(IndexedMesh mesh);

/// The pieces of a surface, each a mesh of its own: bodies that overlap, as exported assemblies do, would
/// show wrong sides as one. A surface with cavities stays whole, since they belong to the piece around them.
[[nodiscard]] std::vector<IndexedMesh> head_pieces(const IndexedMesh& mesh);

}  // namespace gouge
