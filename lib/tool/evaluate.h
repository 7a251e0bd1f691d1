#pragma once

#include "lib/geom/pose.h"
#include "lib/tool/compiled_tool.h"

namespace gouge {

/// Distance and nearest boundary of the tool for one point of its half plane.
struct ToolDistance {
  double signed_distance_mm = 0;  ///< to the boundary; negative inside
  std::uint32_t element = 0;      ///< nearest boundary element
  Vec2 foot = Vec2::Zero();       ///< nearest boundary point (r, z)
  Vec2 normal = Vec2::Zero();     ///< gradient of the signed distance, unit: the exit direction for a point inside
};

/// Finds the nearest boundary element, the signed distance and the exit direction at (r, z), through the BSP or the
/// tree of stretches.
///
/// Units    mm, tool half plane.  Requires r >= 0 and finite values.
/// Ensures  (1) |signed distance - brute force| <= 1e-12 relative to the tool's size. (2) The signed distance is
///          1-Lipschitz and continuous across every bisector.
/// Degenerate  On the boundary the element's own outward normal; on the axis a unit vector of the half plane.
/// Cost     Depth of the BSP, no allocation. Of the tree: its depth and as many elements as are about as near as the
///          nearest. In the centre of a traced ball these are all elements.
/// Source   Ho 1999, thesis 2.4.18.
[[nodiscard]] ToolDistance evaluate(const CompiledTool& tool, double r_mm, double z_mm);

/// Does the same through the tree of stretches alone. It examines every element where the contour turns back on itself
/// (no borders), or where there is no tree.
[[nodiscard]] ToolDistance evaluate_by_stretches(const CompiledTool& tool, double r_mm, double z_mm);

/// Returns the signed distance of evaluate alone, to the last bit.
[[nodiscard]] double signed_distance_mm(const CompiledTool& tool, double r_mm, double z_mm);

/// Returns the signed distance of a point of the part, in part coordinates, to the tool at a pose.
[[nodiscard]] inline double signed_distance_mm(const CompiledTool& tool, const Pose& pose, const Vec3& point) {
  const Vec3 from_tip = point - pose.tip;
  const double z = from_tip.dot(pose.axis);
  return signed_distance_mm(tool, (from_tip - z * pose.axis).norm(), z);
}

/// Returns the distance to one element, its ends included; not signed.
[[nodiscard]] double distance_to(const BoundaryElement& element, const Vec2& q);

/// Returns the same by examining every element: the reference that tests hold the BSP against. The distance is the
/// smallest distance_to; the side follows from how often a ray along r crosses the contour, whatever the element. Where
/// elements tie, a vertex is named before others, else the first.
/// Requires a contour that is closed at the heights of the point.
[[nodiscard]] ToolDistance evaluate_brute_force(const CompiledTool& tool, double r_mm, double z_mm);

/// Returns the distance of one element alone for a point whose nearest element it is.
[[nodiscard]] ToolDistance evaluate_element(const CompiledTool& tool, std::uint32_t element, double r_mm, double z_mm);

}  // namespace gouge
