#pragma once

#include <cstdint>

#include "lib/geom/vec.h"
#include "lib/tool/compiled_tool.h"
#include "lib/tool/evaluate.h"

// First-order bounds. For every point behind a plane tangent to the tool, the depth is at most the distance from the
// plane. This holds in the range in which the plane supports the tool (SupportRange). Proof:
// docs/method/certified_sweep.md.

namespace gouge {

/// A point in tool coordinates and its distance from the tool.
struct ToolSample {
  Vec3 q = Vec3::Zero();
  ToolDistance nearest;
};

[[nodiscard]] ToolSample sample_tool(const CompiledTool& tool, const Vec3& q_tool);

/// The plane {x : normal . x = offset} that is tangent to the tool at the closest point of a sample. Its normal is
/// outward.
struct SupportPlane {
  Vec3 normal = Vec3::UnitZ();
  Vec3 foot = Vec3::Zero();  ///< the boundary point that the plane touches
  double offset_mm = 0;
  SupportRange range;
  std::uint32_t element = 0;  ///< the boundary element that the plane touches

  /// Returns the distance of q behind the plane, positive on the tool's side.
  [[nodiscard]] double depth_mm(const Vec3& q) const { return offset_mm - normal.dot(q); }
};

[[nodiscard]] SupportPlane support_plane(const CompiledTool& tool, const ToolSample& sample);

/// Returns the mirror image of the plane in the tool axis. It is tangent to the tool on the other side.
[[nodiscard]] SupportPlane mirrored(const SupportPlane& plane);

/// Bounds of a set in tool coordinates, for `supports`.
struct SupportedSet {
  double z_lo_mm = 0, z_hi_mm = 0;
  double largest_depth_mm = 0;  ///< largest depth behind the plane
  double smallest_r_mm = 0;     ///< smallest distance from the tool axis
};

/// Returns whether a plane of the tool bounds the depth over a set. With `margin_mm` the bound also holds for points up
/// to that distance outside. For a horizontal face, the contour between the face and the set is tested.
/// Cost     Constant; for a horizontal face linear in the elements of the tool.
[[nodiscard]] bool supports(const CompiledTool& tool, const SupportPlane& plane, const SupportedSet& set,
                            double margin_mm);

}  // namespace gouge
