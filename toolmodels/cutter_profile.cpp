#include <algorithm>
#include <cmath>

#include "toolmodels/cutter_shapes.h"

// The contour of a free profile, which consists of points and arcs.

namespace gouge::detail {
namespace {

using SegmentShape = ProfilePoint::SegmentShape;

std::string point(std::size_t index) { return "point " + std::to_string(index + 1); }

Diagnostic broken(const std::string& message) { return make_error("tool-profile-broken", message); }

Outcome check_point(const ProfileCutter& t, std::size_t i) {
  const ProfilePoint& p = t.points[i];
  if (!std::isfinite(p.r_mm) || !std::isfinite(p.z_mm) || std::abs(p.z_mm) > kLargest_mm || p.r_mm > kLargest_mm)
    return make_error("tool-dimension-too-large",
                      point(i) + " is farther than 100000 mm away; check the unit of the file");
  if (p.r_mm < 0) return broken(point(i) + ": r is " + mm(p.r_mm) + "; a radius is 0 or more");
  if (p.shape == SegmentShape::straight) return Done{};
  if (i == 0)
    return broken(point(i) + " has an arc, but nothing comes before it; arcs lead to a point from the one before");
  if (Outcome good = check_length(point(i) + ": radius", p.radius_mm); !good) return good;
  const double chord = (Vec2(p.r_mm, p.z_mm) - Vec2(t.points[i - 1].r_mm, t.points[i - 1].z_mm)).norm();
  if (p.radius_mm < chord / 2 * (1 - kRelativeSlack))
    return broken(point(i) + ": radius " + mm(p.radius_mm) + " is too small to reach from the point before; at least " +
                  mm(chord / 2) + " is needed");
  return Done{};
}

// Returns the centre of an arc: on the left of the chord for a convex arc, on the right for a concave one.
Vec2 center_of(const Vec2& from, const Vec2& to, double radius_mm, bool is_concave) {
  const Vec2 chord = to - from;
  const double half = 0.5 * chord.norm();
  const double away = std::sqrt(std::max(0.0, (radius_mm - half) * (radius_mm + half)));
  const Vec2 left = Vec2(-chord.y(), chord.x()).normalized();
  return 0.5 * (from + to) + (is_concave ? -away : away) * left;
}

}  // namespace

Result<Profile> make_shape(const ProfileCutter& t) {
  if (t.points.size() < 2)
    return broken("the profile has " + std::to_string(t.points.size()) + " points; it needs at least 2");
  double size = 0;
  for (std::size_t i = 0; i < t.points.size(); ++i) {
    if (Outcome good = check_point(t, i); !good) return good.error();
    size = std::max({size, t.points[i].r_mm, std::abs(t.points[i].z_mm)});
  }
  Vec2 at(0, t.points.front().z_mm);
  ContourMaker contour(at, size);
  for (const ProfilePoint& p : t.points) {
    const Vec2 to(p.r_mm, p.z_mm);
    // An arc of half a circle, up to rounding, has its centre in the middle of the chord.
    const double radius = std::max(p.radius_mm, 0.5 * (to - at).norm());
    if (p.shape == SegmentShape::straight)
      contour.line_to(to);
    else
      contour.arc_to(to, center_of(at, to, radius, p.shape == SegmentShape::concave), radius,
                     p.shape == SegmentShape::concave);
    at = to;
  }
  Result<Profile> made = contour.close("points in order from the tip up, the tool on their left");
  if (!made) return broken(made.error().message);
  return made;
}

}  // namespace gouge::detail
