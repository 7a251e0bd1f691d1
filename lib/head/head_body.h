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
  Surface whole;    ///< all triangles of its file
  Surface surface;  ///< the boundary of what they wind around
  Box3 box;
  /// For each piece of its surface a point inside it, the deepest of some hundred tries, and how deep it is. Where the
  /// boundary is not all of the surface one for each connected part of the inside, or several.
  std::vector<Vec3> cores;
  std::vector<double> core_depths_mm;
  ConvexCover cover;       ///< make_revolved_cover of its surface
  SupportPlanes supports;  ///< of its surface
};

/// Requires what build_mesh ensures. Shells may nest, overlap and cross: depth is measured to the boundary of all.
/// Errors   The code mesh-head-open: the surface is not closed, so its inside is not defined. The code
///          mesh-head-crosses: rounding leaves open where its inside ends.
[[nodiscard]] Result<HeadBody> build_head_body(IndexedMesh mesh);

/// Builds the same bodies `by_mm` farther up the tool axis, as with a longer stick-out. Errors: those of
/// build_head_body.
[[nodiscard]] Result<std::vector<HeadBody>> moved_up(const std::vector<HeadBody>& heads, double by_mm);

/// Returns the connected pieces of a surface, each a mesh of its own.
[[nodiscard]] std::vector<IndexedMesh> shells_of(const IndexedMesh& mesh);

/// Returns the shells of a surface where they are bodies apart. A surface with cavities stays whole, since they belong
/// to the shell around them. So does one whose shells nest or overlap, since no shell shows how deep a point is in all.
[[nodiscard]] std::vector<IndexedMesh> head_pieces(const IndexedMesh& mesh);

}  // namespace gouge
