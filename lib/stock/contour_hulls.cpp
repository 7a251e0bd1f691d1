#include "lib/stock/contour_hulls.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gouge {

namespace {

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Returns whether a direction is between two directions that are at most a half turn apart.
bool is_between(const Vec2& direction, const Vec2& a, const Vec2& b) {
  const double turn = cross(a, b);
  return cross(a, direction) * turn >= 0 && cross(direction, b) * turn >= 0 && direction.dot(a + b) >= 0;
}

bool has_direction(const BoundaryElement& arc, const Vec2& direction) {
  return is_between(direction, arc.a - arc.center, arc.normal) || is_between(direction, arc.normal, arc.b - arc.center);
}

ContourHull hull_of(const BoundaryElement& element) {
  ContourHull hull;
  hull.points = {element.a, element.b};
  hull.reach_mm = std::max(element.a.norm(), element.b.norm());
  hull.around = {std::max(element.a.x(), element.b.x()), std::min(element.a.y(), element.b.y()),
                 std::max(element.a.y(), element.b.y())};
  if (element.kind != ElementKind::arc) return hull;
  hull.reach_mm = element.center.norm() + element.radius_mm;
  // The circle contains the arc.
  hull.around.radius_mm =
      std::max(hull.around.radius_mm, element.center.x() + (element.is_reflex ? 0 : element.radius_mm));
  for (const double side : {-1.0, 1.0}) {
    if (!has_direction(element, Vec2(0, side))) continue;
    hull.around.z_lo_mm = std::min(hull.around.z_lo_mm, element.center.y() + side * element.radius_mm);
    hull.around.z_hi_mm = std::max(hull.around.z_hi_mm, element.center.y() + side * element.radius_mm);
  }
  if (element.is_reflex) {
    // Between its ends the radius is a convex function of the height, except where the arc turns back over itself.
    for (const double side : {-1.0, 1.0}) {
      if (has_direction(element, Vec2(0, side)))
        hull.points.emplace_back(std::max({element.a.x(), element.b.x(), element.center.x()}),
                                 element.center.y() + side * element.radius_mm);
    }
    return hull;
  }
  hull.has_arc = true;
  hull.center = element.center;
  hull.radius_mm = element.radius_mm;
  hull.from = element.a - element.center;
  hull.middle = element.normal;
  hull.to = element.b - element.center;
  return hull;
}

}  // namespace

double ContourHull::highest_mm(const Vec3& direction, const Pose& pose) const {
  const double along = direction.dot(pose.axis);
  const Vec2 flat(std::sqrt(std::max(0.0, 1 - along * along)), along);
  double most = -std::numeric_limits<double>::max();
  for (const Vec2& point : points) most = std::max(most, point.dot(flat));
  if (has_arc && (is_between(flat, from, middle) || is_between(flat, middle, to)))
    most = std::max(most, center.dot(flat) + radius_mm);
  return direction.dot(pose.tip) + most;
}

std::vector<BodyHulls> contour_hulls(const CompiledTool& tool) {
  std::vector<BodyHulls> bodies;
  for (const BoundaryElement& element : tool.elements) {
    if (element.kind == ElementKind::vertex) continue;
    const ContourHull hull = hull_of(element);
    if (bodies.empty() || bodies.back().body != element.body) bodies.push_back({element.body, hull.around, {}});
    ToolCylinder& around = bodies.back().around;
    around.radius_mm = std::max(around.radius_mm, hull.around.radius_mm);
    around.z_lo_mm = std::min(around.z_lo_mm, hull.around.z_lo_mm);
    around.z_hi_mm = std::max(around.z_hi_mm, hull.around.z_hi_mm);
    bodies.back().hulls.push_back(hull);
  }
  return bodies;
}

}  // namespace gouge
