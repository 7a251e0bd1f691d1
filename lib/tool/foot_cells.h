#pragma once

#include <vector>

#include "lib/tool/compiled_tool.h"

namespace gouge {

/// The points of a tool whose nearest boundary point lies on a stretch of one element, in the half plane. They lie on
/// the straight rays that leave the stretch inwards, square to it. Every point of the tool is in one of the cells of
/// its contour.
struct FootCell {
  Vec2 origin = Vec2::Zero();  ///< segment: the foot at parameter 0; else centre of the arc or the vertex
  Vec2 along = Vec2::Zero();   ///< segment: unit direction of the parameter; else zero
  Vec2 inward = Vec2::Zero();  ///< segment: unit
  double radius_mm = 0;        ///< of the arc; 0 for a vertex
  double side = 0;             ///< arcs and vertices: -1 where the rays lead to the centre, +1 away from it
  double from = 0, to = 0;     ///< parameter: mm along a segment, angle about an origin
  [[nodiscard]] bool is_straight() const { return along.squaredNorm() > 0; }
  [[nodiscard]] double middle() const { return 0.5 * (from + to); }
  [[nodiscard]] Vec2 inward_at(double s) const;
  /// Returns the point on the ray of s, t from its foot.
  [[nodiscard]] Vec2 at(double s, double t) const;
  /// Bounds the length of the rays by the cell itself.
  [[nodiscard]] double longest_ray_mm() const;
  /// Returns the largest distance between two rays of the cell, t from their feet. For the middle ray and any other it
  /// is half of that.
  [[nodiscard]] double width_mm(double t) const;
  /// Returns the distance from `point` to the farthest point of the cell at most t from its foot.
  [[nodiscard]] double farthest_mm(const Vec2& place, double t) const;
  /// Returns whether every ray passes within `within_mm` of `point`, a point of the middle ray.
  [[nodiscard]] bool rays_meet(const Vec2& place, double within_mm) const;
};

/// Returns the cells of a tool's contour in its order, none that turns by more than a quarter of a circle.
[[nodiscard]] std::vector<FootCell> foot_cells(const CompiledTool& tool);

}  // namespace gouge
