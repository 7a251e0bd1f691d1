#include "toolmodels/elements.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "lib/base/tolerance.h"
#include "lib/geom/vec.h"

namespace gouge {
namespace {

// A turn at an arc below Tolerance::kTangent is a tangency that was found to half of the digits. An example is the
// point at which a growing arc meets a line. The joint is then moved to its exact place. A joint between two segments
// is smooth only if they are in line.
constexpr double kLargestShift = 1e-3;  // maximum shift of such a joint, relative to the shorter element
constexpr double kLargestSweep_rad = 150 * std::numbers::pi / 180;

BoundaryElement boundary(const ProfileElement& e) {
  BoundaryElement element;
  element.kind = e.is_arc ? ElementKind::arc : ElementKind::segment;
  element.body = e.body;
  element.is_reflex = e.is_arc && e.is_concave;
  element.a = e.a;
  element.b = e.b;
  element.center = e.center;
  element.radius_mm = e.radius_mm;
  element.normal = e.is_arc ? Vec2(sample(e, 2)[1] - e.center).normalized() : outward_normal(start_direction(e));
  return element;
}

// Returns the difference of the bends of the contour behind and before a point where it turns back, seen in one
// direction. Above 0 the contour encloses a crack there, below 0 a blade.
double opening(const ProfileElement& e, const ProfileElement& next) {
  const auto bend = [](const ProfileElement& p) { return p.is_arc ? (p.is_concave ? -1 : 1) / p.radius_mm : 0.0; };
  return bend(next) + bend(e);
}

struct Joint {
  Vec2 at, before, after;  // position, and the directions of travel before and after it
  Body body = Body::cutter;
  double smooth_turn = Tolerance::kExactDirection;
  double opening = 0;
};

std::optional<BoundaryElement> vertex(const Joint& joint) {
  const double turn = cross(joint.before, joint.after);
  const bool is_along = std::abs(turn) <= joint.smooth_turn;
  const bool is_back = joint.before.dot(joint.after) < 0;
  if (is_along && !is_back) return std::nullopt;
  BoundaryElement element;
  element.kind = ElementKind::vertex;
  element.body = joint.body;
  element.a = element.b = joint.at;
  // At a cusp the sign of the turn is only rounding.
  const bool is_cusp = is_along && is_back && std::abs(joint.opening) > 0;
  element.is_reflex = is_cusp ? joint.opening > 0 : turn < 0;
  const Vec2 mean = outward_normal(joint.before) + outward_normal(joint.after);
  const Vec2 along = element.is_reflex ? joint.after : joint.before;
  element.normal = !is_cusp && mean.norm() > Tolerance::kRounding ? Vec2(mean.normalized()) : along;
  return element;
}

std::vector<ProfileElement> without_long_arcs(const Profile& profile) {
  std::vector<ProfileElement> parts;
  for (const ProfileElement& e : profile.elements) {
    const int pieces = 1 + static_cast<int>(sweep_rad(e) / kLargestSweep_rad);
    const std::vector<Vec2> points = sample(e, pieces);
    for (int i = 0; i < pieces; ++i) {
      parts.push_back(e);
      if (pieces == 1) continue;
      parts.back().a = points[static_cast<std::size_t>(i)];
      parts.back().b = points[static_cast<std::size_t>(i) + 1];
    }
  }
  return parts;
}

Vec2 mirrored_travel(const Vec2& direction) { return {direction.x(), -direction.y()}; }

double length_of(const BoundaryElement& e) { return (e.b - e.a).norm(); }

// Returns the point at which two elements that join smoothly have the same normal. For an arc and a segment it is the
// point of the circle with the segment's normal. For two arcs it lies on the line of their centres.
Vec2 joint_position(const BoundaryElement& e, const BoundaryElement& next) {
  const BoundaryElement& arc = e.kind == ElementKind::arc ? e : next;
  const BoundaryElement& other = e.kind == ElementKind::arc ? next : e;
  Vec2 direction = other.normal;
  if (other.kind == ElementKind::arc) direction = other.center - arc.center;
  const double toward = direction.dot(e.b - arc.center) < 0 ? -1 : 1;
  const double length = direction.norm();
  return length > 0 ? Vec2(arc.center + toward * arc.radius_mm / length * direction) : e.b;
}

void put_smooth_joints_right(std::vector<BoundaryElement>& elements) {
  for (std::size_t i = 0; i + 1 < elements.size(); ++i) {
    BoundaryElement &e = elements[i], &next = elements[i + 1];
    const bool is_smooth = e.kind != ElementKind::vertex && next.kind != ElementKind::vertex;
    if (!is_smooth || (e.kind == ElementKind::segment && next.kind == ElementKind::segment)) continue;
    const Vec2 place = joint_position(e, next);
    const double shift = (place - e.b).norm();
    if (place.x() < 0 || shift > kLargestShift * std::min(length_of(e), length_of(next))) continue;
    e.b = next.a = place;
  }
}

}  // namespace

Vec2 normal_at(const BoundaryElement& e, const Vec2& point) {
  if (e.kind == ElementKind::segment) return e.normal;
  const Vec2 out = (point - e.center).normalized();
  return e.is_reflex ? Vec2(-out) : out;
}

std::vector<BoundaryElement> make_elements(const Profile& profile) {
  std::vector<BoundaryElement> elements;
  const std::vector<ProfileElement> parts = without_long_arcs(profile);
  if (parts.empty()) return elements;
  const auto add = [&](const std::optional<BoundaryElement>& e) {
    if (e) elements.push_back(*e);
  };
  const Vec2 first = start_direction(parts.front());
  add(vertex({parts.front().a, mirrored_travel(first), first, parts.front().body}));
  for (std::size_t i = 0; i < parts.size(); ++i) {
    elements.push_back(boundary(parts[i]));
    if (i + 1 == parts.size()) break;
    // A vertex between two bodies belongs to the lower one.
    const double smooth_turn =
        parts[i].is_arc || parts[i + 1].is_arc ? Tolerance::kTangent : Tolerance::kExactDirection;
    add(vertex({parts[i].b, end_direction(parts[i]), start_direction(parts[i + 1]), parts[i].body, smooth_turn,
                opening(parts[i], parts[i + 1])}));
  }
  const Vec2 last = end_direction(parts.back());
  add(vertex({parts.back().b, last, mirrored_travel(last), parts.back().body}));
  put_smooth_joints_right(elements);
  return elements;
}

}  // namespace gouge
