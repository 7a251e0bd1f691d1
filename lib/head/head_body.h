#pragma once

#include <string>
#include <vector>

#include "lib/base/result.h"
#include "lib/head/support_planes.h"
#include "lib/mesh/mesh_findings.h"
#include "lib/surface/surface.h"
#include "lib/tool/convex_cover.h"

namespace gouge {

/// A machine head, angle head, probe or clamp that moves with the tool, in the frame of the tool.
struct HeadBody {
  Surface whole;    ///< all triangles of its file
  Surface surface;  ///< the boundary of the space that the triangles wind around
  Box3 box;
  /// For each piece of the surface a point inside it, the deepest of some hundred tries, with its depth. If the
  /// boundary is not the whole surface, there are one or several for each connected part of the inside.
  std::vector<Vec3> cores;
  std::vector<double> core_depths_mm;
  ConvexCover cover;       ///< make_revolved_cover of the surface
  SupportPlanes supports;  ///< planes of the surface
};

/// Builds a head from a mesh. Requires the guarantees of build_mesh. Shells may nest, overlap and cross: depth is
/// measured to the boundary of all of them.
/// Errors   mesh-head-open: the surface is not closed, so its inside is not defined. mesh-head-crosses: because of
///          rounding it is not known where its inside ends.
[[nodiscard]] Result<HeadBody> build_head_body(IndexedMesh mesh);
/// Builds the same from a surface of such a mesh. Its boundary is not found again if it is known.
[[nodiscard]] Result<HeadBody> build_head_body(const Surface& whole);

/// Builds the same bodies `by_mm` farther up the tool axis, as for a longer stick-out. Errors: those of
/// build_head_body.
[[nodiscard]] Result<std::vector<HeadBody>> moved_up(const std::vector<HeadBody>& heads, double by_mm);

/// Returns the connected pieces of a surface, each as a mesh of its own.
[[nodiscard]] std::vector<IndexedMesh> shells_of(const IndexedMesh& mesh);

/// Returns the shells of a surface as separate surfaces, if they are separate bodies. A surface with cavities stays
/// whole, because a cavity belongs to the shell around it. A surface whose shells nest or overlap stays whole too: no
/// single shell shows how deep a point is in all of them.
[[nodiscard]] std::vector<Surface> head_pieces(const Surface& whole);

}  // namespace gouge
