#pragma once

#include <vector>

#include "lib/geom/pose.h"
#include "lib/stock/motion_tree.h"
#include "lib/tool/compiled_tool.h"

// The tool from outside, as convex solids of revolution of which each spans one element of the contour.

namespace gouge {

/// The hull of the space that one element of the contour sweeps when it turns about the tool axis.
struct ContourHull {
  std::vector<Vec2> points;  ///< of the half plane; their circles span the hull, beside the arc
  bool has_arc = false;      ///< an arc with the solid inside its circle
  Vec2 center = Vec2::Zero(), from = Vec2::Zero(), middle = Vec2::Zero(), to = Vec2::Zero();  ///< of the arc
  double radius_mm = 0;
  double reach_mm = 0;  ///< bounds the distance of its points from the tip
  ToolCylinder around;  ///< contains it

  /// Returns the largest coordinate of the hull along a unit direction, for a tool at a pose.
  [[nodiscard]] double highest_mm(const Vec3& direction, const Pose& pose) const;
};

/// The hulls of one body of the tool: cutter, shank or holder.
struct BodyHulls {
  Body body = Body::cutter;
  ToolCylinder around;  ///< contains them
  std::vector<ContourHull> hulls;
};

/// Returns hulls that contain the solid together: a point of it has the contour beside it at the same height.
[[nodiscard]] std::vector<BodyHulls> contour_hulls(const CompiledTool& tool);

}  // namespace gouge
