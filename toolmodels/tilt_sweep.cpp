#include "toolmodels/tilt_sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "lib/base/tolerance.h"
#include "lib/geom/vec.h"
#include "lib/tool/evaluate.h"
#include "toolmodels/arrangement.h"
#include "toolmodels/offset_curves.h"
#include "toolmodels/trace_regions.h"

namespace gouge {
namespace {

constexpr double kTieNudge_rad = 3e-10;  // angle that breaks a tie of three curves
constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// Returns the angle of a point from the axis, in [-pi, pi]; positive at r > 0.
double angle_of(const Vec2& point) { return std::atan2(point.x(), point.y()); }

Vec2 at_angle(double distance_mm, double angle_rad) {
  return distance_mm * Vec2(std::sin(angle_rad), std::cos(angle_rad));
}

/// Returns the point turned about the tip, away from the axis for a positive angle.
Vec2 swung(const Vec2& point, double angle_rad) {
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  return {point.x() * c + point.y() * s, point.y() * c - point.x() * s};
}

ProfileElement swung(const ProfileElement& element, double angle_rad) {
  ProfileElement moved = element;
  moved.a = swung(element.a, angle_rad);
  moved.b = swung(element.b, angle_rad);
  moved.center = swung(element.center, angle_rad);
  return moved;
}

/// A part of an element along which the distance from the tip grows, shrinks or stays.
struct Stretch {
  ProfileElement element;
  int growth = 0;  // 1, -1 or 0
};

/// Returns the points of an element nearest to and farthest from the tip, but for its ends.
std::vector<Vec2> extremes(const ProfileElement& e, double slack) {
  std::vector<Vec2> found;
  const auto add = [&](const Vec2& point) {
    const bool is_within = (point - e.a).norm() > slack && (point - e.b).norm() > slack;
    if (is_within && detail::passes(e, point, slack)) found.push_back(point);
  };
  if (!e.is_arc) {
    const Vec2 along = start_direction(e);
    add(e.a - e.a.dot(along) * along);
  } else if (e.center.norm() > slack) {
    const Vec2 out = e.center.normalized();
    add(e.center - e.radius_mm * out);
    add(e.center + e.radius_mm * out);
    const auto place = [&](const Vec2& point) { return detail::length_along(e, point); };
    std::ranges::sort(found, {}, place);
  }
  return found;
}

std::vector<Stretch> stretches_of(const Profile& profile, double slack) {
  std::vector<Stretch> all;
  for (const ProfileElement& element : profile.elements) {
    std::vector<Vec2> ends = extremes(element, slack);
    ends.push_back(element.b);
    ProfileElement part = element;
    for (const Vec2& end : ends) {
      part.b = end;
      const double grown = part.b.norm() - part.a.norm();
      const bool is_concentric = part.is_arc && part.center.norm() <= slack;
      all.push_back({part, is_concentric ? 0 : grown > 0 ? 1 : -1});
      part.a = end;
    }
  }
  return all;
}

/// Returns whether the solid is on the convex side of the joint of two stretches, at which the distance from the tip has
/// an extreme value.
bool is_convex_joint(const Stretch& before, const Stretch& after) {
  const Vec2 in = end_direction(before.element), out = start_direction(after.element);
  const double turn = cross(in, out);
  if (std::abs(turn) > Tolerance::kTangent) return turn > 0;
  if (in.dot(out) < 0) return true;
  // Smooth: the solid lies towards the tip where the contour runs to smaller angles.
  const Vec2 point = after.element.a;
  const bool is_inward = in.dot(Vec2(point.y(), -point.x())) < 0;
  return is_inward == (before.growth > 0);
}

/// Collects the curves of which the contour of the union can consist.
class SweptCurves {
 public:
  SweptCurves(const std::vector<Stretch>& stretches, double tilt_rad) : stretches_(stretches), tilt_rad_(tilt_rad) {}

  std::vector<ProfileElement> collect() {
    for (std::size_t k = 0; k < stretches_.size(); ++k) {
      const Stretch& stretch = stretches_[k];
      if (stretch.growth != 0) curves_.push_back(swung(stretch.element, stretch.growth * tilt_rad_));
      if (k == 0) add_start(stretch);
      if (k + 1 == stretches_.size()) add_end(stretch);
      if (k > 0) add_joint(stretches_[k - 1], stretch);
    }
    add_concentric();
    return std::move(curves_);
  }

 private:
  void add_arc(Body body, double distance_mm, double from_rad, double to_rad) {
    const Vec2 a = at_angle(distance_mm, from_rad), b = at_angle(distance_mm, to_rad), tip = Vec2::Zero();
    if (!(distance_mm > 0)) return;
    if (from_rad > to_rad) curves_.push_back(make_convex_arc(body, a, b, tip, distance_mm));
    if (from_rad < to_rad) curves_.push_back(make_concave_arc(body, a, b, tip, distance_mm));
  }

  void add_start(const Stretch& first) {
    if (first.growth > 0) add_arc(first.element.body, first.element.a.norm(), 0, tilt_rad_);
  }
  void add_end(const Stretch& last) {
    if (last.growth > 0) add_arc(last.element.body, last.element.b.norm(), tilt_rad_, 0);
  }

  void add_joint(const Stretch& before, const Stretch& after) {
    if (before.growth * after.growth >= 0 || !is_convex_joint(before, after)) return;
    const Vec2& point = after.element.a;
    const double angle = angle_of(point);
    add_arc(before.element.body, point.norm(), angle + before.growth * tilt_rad_, angle + after.growth * tilt_rad_);
  }

  /// Adds arcs about the tip that the body has itself, longer or shorter at their ends.
  void add_concentric() {
    for (std::size_t k = 0; k < stretches_.size(); ++k) {
      if (stretches_[k].growth != 0) continue;
      const ProfileElement& arc = stretches_[k].element;
      const double before = k > 0 ? stretches_[k - 1].growth * tilt_rad_ : 0;
      const double after = k + 1 < stretches_.size() ? stretches_[k + 1].growth * tilt_rad_ : 0;
      const double from = angle_of(arc.a) + before, to = angle_of(arc.b) + after;
      if (arc.is_concave == (from < to)) add_arc(arc.body, arc.radius_mm, from, to);
    }
  }

  const std::vector<Stretch>& stretches_;
  double tilt_rad_;
  std::vector<ProfileElement> curves_;
};

/// Decides which points the tilted body reaches.
class ReachedPoints {
 public:
  ReachedPoints(const Profile& profile, double tilt_rad, double slack)
      : profile_(profile), tilt_rad_(tilt_rad), slack_(slack), solid_(make_contour_solid(profile)) {}

  /// Returns whether the point is deeper in the union than rounding, along the circle about the tip.
  [[nodiscard]] bool is_inside(const Vec2& point) const {
    const double distance = point.norm();
    if (!(distance > slack_)) return false;
    const double angle = angle_of(point), margin = slack_ / distance;
    double begin = 0;  // of the solid angles that are being joined
    bool is_open = false;
    const std::vector<double> ends = crossings(distance);
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
      const bool is_solid = is_solid_at(at_angle(distance, 0.5 * (ends[k] + ends[k + 1])));
      if (is_solid && !is_open) begin = k == 0 ? -kInfinite : ends[k];
      const bool is_last = k + 2 == ends.size();
      const double end = is_last && is_solid ? kInfinite : ends[is_solid ? k + 1 : k];
      if ((is_open || is_solid) && (!is_solid || is_last) && angle > begin - tilt_rad_ + margin &&
          angle < end + tilt_rad_ - margin)
        return true;
      is_open = is_solid;
    }
    return false;
  }

 private:
  [[nodiscard]] bool is_solid_at(const Vec2& point) const {
    return evaluate_by_stretches(solid_, std::abs(point.x()), point.y()).signed_distance_mm < -slack_;
  }

  /// Returns the angles at which the circle about the tip crosses the contour, with 0 and pi, sorted.
  [[nodiscard]] std::vector<double> crossings(double distance) const {
    const ProfileElement circle = make_convex_arc(Body::cutter, {0, -distance}, {0, distance}, Vec2::Zero(), distance);
    std::vector<double> angles = {0, std::numbers::pi};
    for (const ProfileElement& element : profile_.elements) {
      for (const Vec2& point : detail::meeting_points(circle, element, slack_))
        angles.push_back(std::abs(angle_of(point)));
    }
    std::ranges::sort(angles);
    return angles;
  }

  const Profile& profile_;
  double tilt_rad_, slack_;
  CompiledTool solid_;
};

/// Returns the lowest point of an element: an end, or the lowest point of its circle.
Vec2 lowest_point(const ProfileElement& e, double slack) {
  const Vec2 end = e.b.y() < e.a.y() ? e.b : e.a, pole = e.center - Vec2(0, e.radius_mm);
  return e.is_arc && pole.y() < end.y() && detail::passes(e, pole, slack) ? pole : end;
}

/// Fills the hollow that tilts leave in the underside, level with its rim. Without it no plane would bound the depth near
/// the underside. Returns the contour as it is where there is none.
Profile with_filled_underside_of(const std::vector<ProfileElement>& contour, double slack) {
  std::size_t lowest = 0;
  for (std::size_t k = 1; k < contour.size(); ++k) {
    if (lowest_point(contour[k], slack).y() < lowest_point(contour[lowest], slack).y()) lowest = k;
  }
  const Vec2 rim = lowest_point(contour[lowest], slack);
  if (!(rim.y() < contour.front().a.y() - slack)) return {contour};
  Profile filled;
  filled.elements.push_back(make_segment(contour.front().body, {0, rim.y()}, rim));
  if ((rim - contour[lowest].b).norm() > slack) {
    filled.elements.push_back(contour[lowest]);
    filled.elements.back().a = rim;
  }
  filled.elements.insert(filled.elements.end(), contour.begin() + static_cast<std::ptrdiff_t>(lowest) + 1,
                         contour.end());
  return filled;
}

/// Returns whether no point of the body is lower than its beginning on the axis.
bool begins_lowest(const Profile& profile, double slack) {
  const double start = profile.elements.front().a.y();
  return std::ranges::all_of(profile.elements,
                             [&](const ProfileElement& e) { return lowest_point(e, slack).y() >= start - slack; });
}

std::optional<Profile> try_sweep(const Profile& profile, double tilt_rad, double size) {
  const double slack = Tolerance::kConstruction * size;
  const std::vector<Stretch> stretches = stretches_of(profile, slack);
  detail::Arrangement arrangement = detail::arrange(SweptCurves(stretches, tilt_rad).collect(), slack);
  const ReachedPoints reached(profile, tilt_rad, 10 * slack);
  std::erase_if(arrangement.pieces,
                [&](const detail::CurvePiece& piece) { return reached.is_inside(detail::middle(piece.curve)); });
  const auto contour = detail::outer_contour(arrangement);
  if (!contour) return std::nullopt;
  return begins_lowest(profile, slack) ? with_filled_underside_of(*contour, slack) : Profile{*contour};
}

}  // namespace

Result<Profile> sweep_tilts(const Profile& profile, double max_tilt_rad) {
  if (profile.elements.empty() || !(max_tilt_rad > 0)) return profile;
  const double size = size_of(profile);
  for (int attempt = 0; attempt < 4; ++attempt) {
    std::optional<Profile> made = try_sweep(profile, max_tilt_rad + attempt * kTieNudge_rad, size);
    if (made && verify_profile(*made).empty()) return *std::move(made);
  }
  return make_error("tool-not-closed",
                    "tilted by the axis tolerance, its contour does not join from the tip to the top");
}

namespace {

/// Returns the points of an element at a height, but for its ends.
std::vector<Vec2> points_at(const ProfileElement& e, double height_mm, double slack) {
  std::vector<Vec2> found;
  if (e.is_arc) {
    const double rise = height_mm - e.center.y(), half2 = (e.radius_mm - rise) * (e.radius_mm + rise);
    if (!(half2 > 0)) return {};
    for (const double side : {-std::sqrt(half2), std::sqrt(half2)}) found.emplace_back(e.center.x() + side, height_mm);
  } else if (std::abs(e.b.y() - e.a.y()) > slack) {
    found.emplace_back(e.a + (height_mm - e.a.y()) / (e.b.y() - e.a.y()) * (e.b - e.a));
  }
  std::erase_if(found, [&](const Vec2& p) {
    return (p - e.a).norm() <= slack || (p - e.b).norm() <= slack || !detail::passes(e, p, slack);
  });
  return found;
}

/// Returns the heights at which a contour turns from going up to going down, or back.
std::vector<double> turning_heights(const Profile& profile, double slack) {
  std::vector<double> heights;
  for (std::size_t k = 0; k < profile.elements.size(); ++k) {
    const ProfileElement& e = profile.elements[k];
    if (k > 0 && end_direction(profile.elements[k - 1]).y() * start_direction(e).y() < 0) heights.push_back(e.a.y());
    if (!e.is_arc) continue;
    for (const double side : {-1.0, 1.0}) {
      const Vec2 pole = e.center + Vec2(0, side * e.radius_mm);
      if (detail::passes(e, pole, slack)) heights.push_back(pole.y());
    }
  }
  return heights;
}

}  // namespace

Profile cut_at_turns(const Profile& profile) {
  const double slack = 1e3 * Tolerance::kConstruction * size_of(profile);
  const std::vector<double> heights = turning_heights(profile, slack);
  Profile cut;
  for (const ProfileElement& element : profile.elements) {
    std::vector<Vec2> ends;
    for (const double height : heights) {
      for (const Vec2& point : points_at(element, height, slack)) {
        if (std::ranges::none_of(ends, [&](const Vec2& end) { return (end - point).norm() <= slack; }))
          ends.push_back(point);
      }
    }
    std::ranges::sort(ends, {}, [&](const Vec2& point) { return detail::length_along(element, point); });
    ends.push_back(element.b);
    ProfileElement part = element;
    for (const Vec2& end : ends) {
      part.b = end;
      cut.elements.push_back(part);
      part.a = end;
    }
  }
  return cut;
}

}  // namespace gouge
