#include "toolmodels/offset_curves.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lib/base/tolerance.h"
#include "lib/geom/vec.h"

namespace gouge::detail {
namespace {

Vec2 mirrored(const Vec2& v) { return {-v.x(), v.y()}; }

ProfileElement moved_out(const ProfileElement& e, double growth) {
  ProfileElement moved = e;
  if (!(growth > 0)) return moved;
  if (!e.is_arc) {
    const Vec2 shift = growth * outward_normal(start_direction(e));
    moved.a += shift;
    moved.b += shift;
    return moved;
  }
  moved.radius_mm = e.is_concave ? e.radius_mm - growth : e.radius_mm + growth;
  const double factor = moved.radius_mm / e.radius_mm;
  moved.a = e.center + factor * (e.a - e.center);
  moved.b = e.center + factor * (e.b - e.center);
  return moved;
}

// Returns whether the element is still there after the growth: a hollow that is not wider than the growth is closed.
bool survives(const ProfileElement& e, double growth, double slack) {
  return !e.is_arc || !e.is_concave || e.radius_mm > growth + slack;
}

void add_corner(Body body, const Vec2& corner, const Vec2& before, const Vec2& after, double growth,
                std::vector<ProfileElement>& curves) {
  if (cross(before, after) < -Tolerance::kExactDirection) return;
  if (cross(before, after) <= Tolerance::kExactDirection && before.dot(after) > 0) return;
  curves.push_back(make_convex_arc(body, corner + growth * before, corner + growth * after, corner, growth));
}

std::vector<Vec2> meet_lines(const ProfileElement& c, const ProfileElement& d) {
  const Vec2 u = c.b - c.a;
  const Vec2 v = d.b - d.a;
  const double det = cross(u, v);
  if (std::abs(det) <= Tolerance::kSingular * u.norm() * v.norm()) return {};
  return {c.a + cross(d.a - c.a, v) / det * u};
}

std::vector<Vec2> meet_line_circle(const ProfileElement& line, const ProfileElement& arc, double slack) {
  const Vec2 u = start_direction(line);
  const Vec2 foot = line.a + (arc.center - line.a).dot(u) * u;
  const double distance = std::abs(cross(u, arc.center - line.a));
  if (distance > arc.radius_mm + slack) return {};
  const double half_chord2 = (arc.radius_mm - distance) * (arc.radius_mm + distance);
  if (half_chord2 <= 0) return {foot};
  const double half_chord = std::sqrt(half_chord2);
  return {foot - half_chord * u, foot + half_chord * u};
}

// Returns where two circles meet. Coordinates are computed from the smaller circle, whose digits are kept if the other
// is almost straight.
std::vector<Vec2> meet_circles(const ProfileElement& one, const ProfileElement& other, double slack) {
  const bool is_first_smaller = one.radius_mm < other.radius_mm;
  const ProfileElement& c = is_first_smaller ? one : other;
  const ProfileElement& d = is_first_smaller ? other : one;
  const Vec2 between = d.center - c.center;
  const double distance = between.norm();
  if (distance <= slack) return {};
  if (distance > c.radius_mm + d.radius_mm + slack) return {};
  if (distance < std::abs(c.radius_mm - d.radius_mm) - slack) return {};
  const Vec2 u = between / distance;
  const double along = 0.5 * (distance + (c.radius_mm - d.radius_mm) * (c.radius_mm + d.radius_mm) / distance);
  const double height2 = (c.radius_mm - along) * (c.radius_mm + along);
  if (height2 <= 0) return {c.center + std::clamp(along, -c.radius_mm, c.radius_mm) * u};
  const Vec2 sideways = std::sqrt(height2) * Vec2(-u.y(), u.x());
  return {c.center + along * u - sideways, c.center + along * u + sideways};
}

}  // namespace

std::vector<ProfileElement> offset_curves(const Profile& profile, double growth) {
  if (!(growth > 0)) return profile.elements;
  std::vector<ProfileElement> curves;
  const double slack = Tolerance::kConstruction * (size_of(profile) + growth);
  const std::vector<ProfileElement>& elements = profile.elements;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const ProfileElement& e = elements[i];
    const Vec2 after = outward_normal(start_direction(e));
    if (i > 0)
      add_corner(elements[i - 1].body, e.a, outward_normal(end_direction(elements[i - 1])), after, growth, curves);
    else if (cross(mirrored(after), after) > 0)  // a tip on the axis has the half of its arc at r >= 0
      add_corner(e.body, e.a, Vec2(0, -1), after, growth, curves);
    if (survives(e, growth, slack)) curves.push_back(moved_out(e, growth));
  }
  if (elements.empty()) return curves;
  const Vec2 before = outward_normal(end_direction(elements.back()));
  if (cross(before, mirrored(before)) > 0)
    add_corner(elements.back().body, elements.back().b, before, Vec2(0, 1), growth, curves);
  return curves;
}

double length_along(const ProfileElement& curve, const Vec2& point) {
  if (!curve.is_arc) return (point - curve.a).dot(start_direction(curve));
  const Vec2 u = curve.a - curve.center;
  const Vec2 v = point - curve.center;
  double angle = std::atan2(cross(u, v), u.dot(v));
  if (curve.is_concave) angle = -angle;
  if (angle < 0) angle += 2 * std::numbers::pi;
  const double sweep = sweep_rad(curve);
  return angle > sweep + (2 * std::numbers::pi - sweep) / 2 ? angle - 2 * std::numbers::pi : angle;
}

double curve_length(const ProfileElement& curve) {
  return curve.is_arc ? sweep_rad(curve) : (curve.b - curve.a).norm();
}

bool passes(const ProfileElement& curve, const Vec2& point, double slack) {
  if ((point - curve.a).norm() <= slack || (point - curve.b).norm() <= slack) return true;
  const double off = curve.is_arc ? std::abs((point - curve.center).norm() - curve.radius_mm)
                                  : std::abs(cross(start_direction(curve), point - curve.a));
  const double length = length_along(curve, point);
  return off <= slack && length > 0 && length < curve_length(curve);
}

std::vector<Vec2> meeting_points(const ProfileElement& c, const ProfileElement& d, double slack) {
  std::vector<Vec2> points;
  if (!c.is_arc && !d.is_arc)
    points = meet_lines(c, d);
  else if (!c.is_arc)
    points = meet_line_circle(c, d, slack);
  else if (!d.is_arc)
    points = meet_line_circle(d, c, slack);
  else
    points = meet_circles(c, d, slack);
  std::erase_if(points, [&](const Vec2& p) { return !passes(c, p, slack) || !passes(d, p, slack); });
  return points;
}

std::vector<Vec2> axis_points(const ProfileElement& curve, double slack) {
  std::vector<Vec2> points;
  if (!curve.is_arc) {
    const double run = curve.b.x() - curve.a.x();
    if ((curve.a.x() < 0) != (curve.b.x() < 0) && std::abs(run) > 0)
      points.emplace_back(0, curve.a.y() - curve.a.x() / run * (curve.b.y() - curve.a.y()));
  } else if (std::abs(curve.center.x()) < curve.radius_mm) {
    const double half = std::sqrt((curve.radius_mm - curve.center.x()) * (curve.radius_mm + curve.center.x()));
    points = {{0, curve.center.y() - half}, {0, curve.center.y() + half}};
  }
  std::erase_if(points, [&](const Vec2& p) { return !passes(curve, p, slack); });
  return points;
}

Vec2 middle(const ProfileElement& curve) {
  return curve.is_arc ? sample(curve, 2)[1] : Vec2(0.5 * (curve.a + curve.b));
}

}  // namespace gouge::detail
