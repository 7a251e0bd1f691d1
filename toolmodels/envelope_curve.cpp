#include "toolmodels/envelope_curve.h"

#include <algorithm>
#include <cmath>

namespace gouge::detail {
namespace {

double cross(const Vec2& u, const Vec2& v) {
  return u.x() * v.y() - u.y() * v.x();
}

bool has_height(const EnvelopeCurve& c, double z, double slack) {
  return z >= c.a.y() - slack && z <= c.b.y() + slack;
}

bool is_on_its_half(const EnvelopeCurve& c, const Vec2& p, double slack) {
  if (!c.is_arc) return true;
  return c.is_concave ? p.x() <= c.center.x() + slack : p.x() >= c.center.x() - slack;
}

std::vector<Vec2> cross_lines(const EnvelopeCurve& c, const EnvelopeCurve& d) {
  const Vec2 u = c.b - c.a;
  const Vec2 v = d.b - d.a;
  const double det = cross(u, v);
  if (std::abs(det) <= 1e-14 * u.norm() * v.norm()) return {};
  return {c.a + cross(d.a - c.a, v) / det * u};
}

std::vector<Vec2> cross_line_circle(const EnvelopeCurve& line, const EnvelopeCurve& arc) {
  const Vec2 u = (line.b - line.a).normalized();
  const Vec2 foot = line.a + (arc.center - line.a).dot(u) * u;
  const double distance = cross(u, arc.center - line.a);
  const double half_chord2 = (arc.radius_mm - distance) * (arc.radius_mm + distance);
  if (half_chord2 < 0) return {};
  const double half_chord = std::sqrt(half_chord2);
  return {foot - half_chord * u, foot + half_chord * u};
}

std::vector<Vec2> cross_circles(const EnvelopeCurve& c, const EnvelopeCurve& d) {
  const Vec2 between = d.center - c.center;
  const double distance = between.norm();
  if (!(distance > 0)) return {};
  const Vec2 u = between / distance;
  const double along =
      0.5 * (distance + (c.radius_mm - d.radius_mm) * (c.radius_mm + d.radius_mm) / distance);
  const double height2 = (c.radius_mm - along) * (c.radius_mm + along);
  if (height2 < 0) return {};
  const Vec2 sideways = std::sqrt(height2) * Vec2(-u.y(), u.x());
  return {c.center + along * u - sideways, c.center + along * u + sideways};
}

EnvelopeCurve grown_segment(const ProfileElement& e, double growth) {
  const Vec2 shift = growth * outward_normal(start_direction(e));
  return {e.body, false, false, e.a + shift, e.b + shift, Vec2::Zero(), 0};
}

EnvelopeCurve grown_arc(const ProfileElement& e, double growth) {
  const double radius = e.is_concave ? e.radius_mm - growth : e.radius_mm + growth;
  const auto moved = [&](const Vec2& p) -> Vec2 {
    return growth > 0 ? Vec2(e.center + radius / e.radius_mm * (p - e.center)) : p;
  };
  return {e.body, true, e.is_concave, moved(e.a), moved(e.b), e.center, radius};
}

void add_if_rising(const EnvelopeCurve& c, double slack, std::vector<EnvelopeCurve>& curves) {
  if (c.b.y() - c.a.y() > slack) curves.push_back(c);
}

// The arc about a convex corner, between the normals of its neighbours, as far as it faces outward.
void add_corner(Body body, const Vec2& corner, Vec2 before, Vec2 after, double growth, double slack,
                std::vector<EnvelopeCurve>& curves) {
  if (cross(before, after) <= 1e-12 && before.dot(after) > 0) return;
  if (cross(before, after) < -1e-12) return;
  if (before.x() < 0) before = Vec2(0, -1);
  if (after.x() < 0) after = Vec2(0, 1);
  add_if_rising({body, true, false, corner + growth * before, corner + growth * after, corner, growth}, slack,
                curves);
}

Vec2 mirrored(const Vec2& v) {
  return {-v.x(), v.y()};
}

}  // namespace

ProfileElement EnvelopeCurve::element(const Vec2& from, const Vec2& to) const {
  if (!is_arc) return make_segment(body, from, to);
  return is_concave ? make_concave_arc(body, from, to, center, radius_mm)
                    : make_convex_arc(body, from, to, center, radius_mm);
}

double radius_at(const EnvelopeCurve& c, double z) {
  if (z <= c.a.y()) return c.a.x();
  if (z >= c.b.y()) return c.b.x();
  if (!c.is_arc) return c.a.x() + (c.b.x() - c.a.x()) * ((z - c.a.y()) / (c.b.y() - c.a.y()));
  const double h = z - c.center.y();
  const double half = std::sqrt(std::max(0.0, (c.radius_mm - h) * (c.radius_mm + h)));
  return c.is_concave ? c.center.x() - half : c.center.x() + half;
}

std::vector<Vec2> crossings(const EnvelopeCurve& c, const EnvelopeCurve& d, double slack) {
  std::vector<Vec2> points;
  if (!c.is_arc && !d.is_arc)
    points = cross_lines(c, d);
  else if (!c.is_arc)
    points = cross_line_circle(c, d);
  else if (!d.is_arc)
    points = cross_line_circle(d, c);
  else
    points = cross_circles(c, d);
  std::erase_if(points, [&](const Vec2& p) {
    return !has_height(c, p.y(), slack) || !has_height(d, p.y(), slack) || !is_on_its_half(c, p, slack) ||
           !is_on_its_half(d, p, slack);
  });
  return points;
}

void add_curves(const Profile& profile, double growth, std::vector<EnvelopeCurve>& curves) {
  const double slack = 1e-10 * (size_of(profile) + growth);
  const std::vector<ProfileElement>& elements = profile.elements;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const ProfileElement& e = elements[i];
    if (growth > 0) {
      const Vec2 after = outward_normal(start_direction(e));
      const Vec2 before = i == 0 ? mirrored(after) : outward_normal(end_direction(elements[i - 1]));
      add_corner(e.body, e.a, before, after, growth, slack, curves);
    }
    if (!e.is_arc)
      add_if_rising(grown_segment(e, growth), slack, curves);
    else if (!e.is_concave || e.radius_mm > growth + slack)
      add_if_rising(grown_arc(e, growth), slack, curves);
  }
  if (growth > 0 && !elements.empty()) {
    const Vec2 before = outward_normal(end_direction(elements.back()));
    add_corner(elements.back().body, elements.back().b, before, mirrored(before), growth, slack, curves);
  }
}

}  // namespace gouge::detail
