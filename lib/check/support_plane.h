#pragma once

#include <cstdint>

#include "lib/geom/vec.h"
#include "lib/tool/compiled_tool.h"
#include "lib/tool/evaluate.h"

// First-order bounds. Behind a plane tangent to the tool every point is at most as deep as its distance from the plane.
// That holds as far as the plane supports the tool (SupportRange). Proof: docs/method/certified_sweep.md.

namespace gouge {

/// A point in tool coordinates with the tool's distance for it.
struct ToolSample {
  Vec3 q = Vec3::Zero();
  ToolDistance nearest;
};

[[nodiscard]] ToolSample sample_tool(const CompiledTool& tool, const Vec3& q_tool);

/// The plane {x : normal . x = offset} tangent to the tool at the foot of a sample, normal outward.
struct SupportPlane {
  Vec3 normal = Vec3::UnitZ();
  Vec3 foot = Vec3::Zero();  ///< the boundary point it touches
  double offset_mm = 0;
  SupportRange range;
  std::uint32_t element = 0;  ///< the boundary element it touches

  /// Returns how far q lies behind the plane (positive on the tool's side).
  [[nodiscard]] double depth_mm(const Vec3& q) const { return offset_mm - normal.dot(q); }
};

[[nodiscard]] SupportPlane support_plane(const CompiledTool& tool, const ToolSample& sample);

/// Returns the plane mirrored in the tool axis: just as tangent, on the other side.
[[nodiscard]] SupportPlane mirrored(const SupportPlane& plane);

/// A set in tool coordinates, as far as `supports` needs to know it.
struct SupportedSet {
  double z_lo_mm = 0, z_hi_mm = 0;
  double largest_depth_mm = 0;  ///< behind the plane
  double smallest_r_mm = 0;     ///< distance from the tool axis
};

/// Returns whether a plane of the tool bounds its depth over a set. `margin_mm` extends the bound up to that far
/// outside as well. For a horizontal face the contour between the face and the set is tested.
/// Cost     Constant; for a horizontal face linear in the elements of the tool.
[[nodiscard]] bool supports(const CompiledTool& tool, const SupportPlane& plane, const SupportedSet& set,
                            double margin_mm);

}  // namespace gouge
