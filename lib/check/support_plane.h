#pragma once

#include "lib/geom/vec.h"
#include "lib/tool/compiled_tool.h"
#include "lib/tool/evaluate.h"

// First-order bounds: behind a plane tangent to the tool nothing is deeper than its distance from the plane,
// as far as the plane supports the tool (SupportRange). Proof: docs/algorithms/certified_sweep.md.

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

  /// How far q lies behind the plane (positive on the tool's side).
  [[nodiscard]] double depth_mm(const Vec3& q) const { return offset_mm - normal.dot(q); }
};

[[nodiscard]] SupportPlane support_plane(const CompiledTool& tool, const ToolSample& sample);

/// The plane mirrored in the tool axis: just as tangent, on the other side.
[[nodiscard]] SupportPlane mirrored(const SupportPlane& plane);

/// Whether the plane bounds the tool over a set: z of the set in [z_lo, z_hi], its largest depth behind the
/// plane, its smallest distance from the tool axis. `margin_mm` asks for the bound up to that far outside as
/// well.
[[nodiscard]] bool supports(const SupportPlane& plane, double z_lo_mm, double z_hi_mm, double largest_depth_mm,
                            double smallest_r_mm, double margin_mm);

}  // namespace gouge
