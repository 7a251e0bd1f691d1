#pragma once

#include "lib/geom/pose.h"
#include "lib/tool/compiled_tool.h"

namespace gouge {

/// Signed distance and nearest boundary point of the tool for one point of its half plane.
struct ToolDistance {
  double signed_distance_mm = 0;  ///< to the boundary; negative inside
  std::uint32_t element = 0;      ///< nearest boundary element
  Vec2 foot = Vec2::Zero();       ///< nearest boundary point (r, z)
  Vec2 normal = Vec2::Zero();     ///< gradient of the signed distance, unit; for a point inside it is the exit
                                  ///< direction
};

/// Finds the nearest boundary element, the signed distance and the exit direction at (r, z). Uses the BSP or the tree
/// of stretches.
///
/// Units    mm, tool half plane.  Requires r >= 0 and finite values.
/// Ensures  (1) |signed distance - brute force| <= 1e-12 relative to the tool's size. (2) The signed distance is
///          1-Lipschitz and continuous across every bisector.
/// Degenerate  On the boundary the normal is the element's own outward normal; on the axis it is a unit vector of the
///             half plane.
/// Cost     With a BSP: its depth, no allocation. With a tree: its depth plus the number of elements about as near as
///          the nearest one. At the centre of a traced ball these are all elements.
/// Source   Ho 1999, thesis 2.4.18.
[[nodiscard]] ToolDistance evaluate(const CompiledTool& tool, double r_mm, double z_mm);

/// Finds the same as `evaluate`, by the tree of stretches alone. It examines every element if the contour turns back on
/// itself (no borders) or if there is no tree.
[[nodiscard]] ToolDistance evaluate_by_stretches(const CompiledTool& tool, double r_mm, double z_mm);

/// Returns the signed distance that `evaluate` finds, to the last bit.
[[nodiscard]] double signed_distance_mm(const CompiledTool& tool, double r_mm, double z_mm);

/// Returns the signed distance of a point of the part, in part coordinates, to the tool at a pose.
[[nodiscard]] inline double signed_distance_mm(const CompiledTool& tool, const Pose& pose, const Vec3& point) {
  const Vec3 from_tip = point - pose.tip;
  const double z = from_tip.dot(pose.axis);
  return signed_distance_mm(tool, (from_tip - z * pose.axis).norm(), z);
}

/// Returns the unsigned distance to one element, including its ends.
[[nodiscard]] double distance_to(const BoundaryElement& element, const Vec2& q);

/// Finds the same as `evaluate` by examining every element. Tests use it as the reference for the BSP. The distance is
/// the minimum of distance_to. The side is given by the number of times that a ray along r crosses the contour. Of
/// equally near elements it names a vertex, otherwise the first one.
/// Requires a contour that is closed at the heights of the point.
[[nodiscard]] ToolDistance evaluate_brute_force(const CompiledTool& tool, double r_mm, double z_mm);

/// Returns the distance to one element alone, for a point whose nearest element it is.
[[nodiscard]] ToolDistance evaluate_element(const CompiledTool& tool, std::uint32_t element, double r_mm, double z_mm);

}  // namespace gouge
