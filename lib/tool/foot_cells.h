#pragma once

#include <vector>

#include "lib/tool/compiled_tool.h"

namespace gouge {

/// The points of a tool whose nearest boundary point lies on one part of one element, in the half plane. They lie on
/// the straight rays that leave that part inwards, perpendicular to it. Every point of the tool is in one of the cells
/// of its contour.
struct FootCell {
  Vec2 origin = Vec2::Zero();  ///< segment: the foot at parameter 0; otherwise the centre of the arc or the vertex
  Vec2 along = Vec2::Zero();   ///< segment: unit direction of the parameter; else zero
  Vec2 inward = Vec2::Zero();  ///< segment: unit
  double radius_mm = 0;        ///< of the arc; 0 for a vertex
  double side = 0;             ///< arcs and vertices: -1 if the rays lead to the centre, +1 if they lead away from it
  double from = 0, to = 0;     ///< parameter: mm along a segment, or angle about `origin`
  [[nodiscard]] bool is_straight() const { return along.squaredNorm() > 0; }
  [[nodiscard]] double middle() const { return 0.5 * (from + to); }
  [[nodiscard]] Vec2 inward_at(double s) const;
  /// Returns the point of ray `s` at distance `t` from its foot.
  [[nodiscard]] Vec2 at(double s, double t) const;
  /// Returns a bound of the length of the rays from the form of the cell alone.
  [[nodiscard]] double longest_ray_mm() const;
  /// Returns the maximum distance between two rays of the cell at distance `t` from their feet. Between the middle ray
  /// and any other ray it is half of that.
  [[nodiscard]] double width_mm(double t) const;
  /// Returns the distance from `place` to the farthest point of the cell within `t` of its foot.
  [[nodiscard]] double farthest_mm(const Vec2& place, double t) const;
  /// Returns whether every ray passes within `within_mm` of `place`, a point of the middle ray.
  [[nodiscard]] bool rays_meet(const Vec2& place, double within_mm) const;
};

/// Returns the cells of a tool's contour in its order. Each cell turns by at most a quarter of a circle.
[[nodiscard]] std::vector<FootCell> foot_cells(const CompiledTool& tool);

}  // namespace gouge
