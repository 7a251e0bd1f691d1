#include <cmath>
#include <limits>

#include "lib/geom/vec.h"
#include "lib/tool/evaluate.h"

namespace gouge {
namespace {

double turn_of(const BoundaryElement& arc) { return arc.is_reflex ? -1.0 : 1.0; }

bool has_point_within(const BoundaryElement& e, const Vec2& q) {
  if (e.kind == ElementKind::vertex) return true;
  if (e.kind == ElementKind::segment) {
    const Vec2 along = e.b - e.a;
    return along.dot(q - e.a) >= 0 && along.dot(q - e.b) <= 0;
  }
  const Vec2 away = q - e.center;
  return turn_of(e) * cross(e.a - e.center, away) >= 0 && turn_of(e) * cross(away, e.b - e.center) >= 0;
}

const Vec2& nearer_end(const BoundaryElement& e, const Vec2& q) {
  return (q - e.b).squaredNorm() < (q - e.a).squaredNorm() ? e.b : e.a;
}

// Returns whether the ray from q along +r can meet a stretch of contour on which the height only rises or only falls. A
// stretch includes its lower end but not its upper end. So the ray counts a joint of two stretches once.
bool holds_height(double from_z, double to_z, double z) { return (from_z <= z) != (to_z <= z); }

int crossings_with_segment(const BoundaryElement& e, const Vec2& q) {
  if (!holds_height(e.a.y(), e.b.y(), q.y())) return 0;
  const double left = cross(e.b - e.a, q - e.a);
  return (e.b.y() > e.a.y() ? left > 0 : left < 0) ? 1 : 0;
}

// Returns whether the contour rises where it passes `at` on an arc. At a pole `inward` decides; it is +1 for the start.
bool rises_at(const BoundaryElement& arc, const Vec2& at, double inward) {
  const double out = at.x() - arc.center.x();
  if (out > 0 || out < 0) return turn_of(arc) * out > 0;
  return inward * (at.y() - arc.center.y()) < 0;
}

int crossings_with_arc(const BoundaryElement& e, const Vec2& q) {
  const Vec2 away = q - e.center;
  const bool is_within = away.squaredNorm() < e.radius_mm * e.radius_mm;
  const auto crossing = [&](double from_z, double to_z, bool is_up) {
    if (!holds_height(from_z, to_z, q.y())) return 0;
    const bool is_right_half = is_up != e.is_reflex;
    return (is_right_half ? away.x() < 0 || is_within : away.x() < 0 && !is_within) ? 1 : 0;
  };
  const bool rises = rises_at(e, e.a, 1);
  const bool ends_rising = rises_at(e, e.b, -1);
  if (rises == ends_rising) return crossing(e.a.y(), e.b.y(), rises);
  const double pole = e.center.y() + (rises ? e.radius_mm : -e.radius_mm);
  return crossing(e.a.y(), pole, rises) + crossing(pole, e.b.y(), ends_rising);
}

bool is_inside(const CompiledTool& tool, const Vec2& q) {
  int crossings = 0;
  for (const BoundaryElement& e : tool.elements) {
    if (e.kind == ElementKind::segment) crossings += crossings_with_segment(e, q);
    if (e.kind == ElementKind::arc) crossings += crossings_with_arc(e, q);
  }
  return crossings % 2 == 1;
}

}  // namespace

double distance_to(const BoundaryElement& element, const Vec2& q) {
  if (!has_point_within(element, q)) return std::sqrt((q - nearer_end(element, q)).squaredNorm());
  if (element.kind == ElementKind::segment) return std::abs(element.normal.dot(q - element.a));
  if (element.kind == ElementKind::vertex) return std::sqrt((q - element.a).squaredNorm());
  return std::abs(std::sqrt((q - element.center).squaredNorm()) - element.radius_mm);
}

ToolDistance evaluate_brute_force(const CompiledTool& tool, double r_mm, double z_mm) {
  const Vec2 q(r_mm, z_mm);
  double distance = std::numeric_limits<double>::infinity();
  std::uint32_t nearest = 0;
  for (std::uint32_t i = 0; i < tool.elements.size(); ++i) {
    const double here = distance_to(tool.elements[i], q);
    // At an equal distance a vertex has priority over the ends of its neighbours.
    if (here < distance || (!(here > distance) && tool.elements[i].kind == ElementKind::vertex)) nearest = i;
    if (here < distance) distance = here;
  }
  const BoundaryElement& e = tool.elements[nearest];
  const double sign = is_inside(tool, q) ? -1 : 1;
  ToolDistance result = evaluate_element(tool, nearest, r_mm, z_mm);
  if (!has_point_within(e, q)) {  // the nearest point is the end of a smooth joint
    result.foot = nearer_end(e, q);
    if (distance > 0) result.normal = sign / distance * (q - result.foot);
  }
  result.signed_distance_mm = sign * distance;
  return result;
}

}  // namespace gouge
