#include <algorithm>
#include <cmath>

#include "lib/base/tolerance.h"
#include "toolmodels/cutter_shapes.h"

// Contours of the cutters that are made of circle segments: lollipop, barrel, oval, lens.

namespace gouge::detail {
namespace {

// The flank of a barrel mill, as an arc.
struct Flank {
  Vec2 center;
  double radius_mm;

  [[nodiscard]] bool has_height(double z) const { return std::abs(z - center.y()) < radius_mm; }
  [[nodiscard]] double radius_at(double z) const {
    const double h = z - center.y();
    return center.x() + std::sqrt((radius_mm - h) * (radius_mm + h));
  }
  // Returns the largest possible radius of the corner arc. An arc of this radius between the tip plane and the flank
  // begins on the axis.
  [[nodiscard]] double largest_corner_mm() const {
    return (radius_mm * radius_mm - center.squaredNorm()) / (2 * (radius_mm - center.y()));
  }
};

Flank flank_of(const BarrelCutter& t) {
  const Vec2 normal(cosine(t.taper_angle_deg), -sine(t.taper_angle_deg));
  return {Vec2(t.diameter_mm / 2, t.axial_distance_mm) - t.profile_radius_mm * normal, t.profile_radius_mm};
}

Outcome check_barrel(const BarrelCutter& t) {
  if (Outcome good = check_length("diameter", t.diameter_mm); !good) return good;
  if (Outcome good = check_length("profile_radius", t.profile_radius_mm); !good) return good;
  if (Outcome good = check_angle("taper_angle", t.taper_angle_deg, -90, 90); !good) return good;
  if (Outcome good = check_not_negative("axial_distance", t.axial_distance_mm); !good) return good;
  if (Outcome good = check_length("length", t.length_mm); !good) return good;
  if (!(t.corner_radius_mm >= 0)) return check_corner_radius(t.corner_radius_mm, t.diameter_mm);
  const Flank flank = flank_of(t);
  if (!flank.has_height(0) || !(flank.radius_at(0) > 0))
    return contradict(
        "profile_radius " + mm(t.profile_radius_mm) + " and axial_distance " + mm(t.axial_distance_mm) +
        ": the flank meets the axis above the tip; give a larger profile_radius or a smaller axial_distance");
  if (!flank.has_height(t.length_mm) || !(flank.radius_at(t.length_mm) > 0))
    return contradict("profile_radius " + mm(t.profile_radius_mm) +
                      ": the flank meets the axis below the top of the flutes at " + mm(t.length_mm) +
                      "; give a larger profile_radius or a smaller length");
  const double largest = std::min(flank.largest_corner_mm(), t.profile_radius_mm);
  if (t.corner_radius_mm > largest * (1 + Tolerance::kSingleSum))
    return make_error("tool-corner-radius-too-large", "corner_radius " + mm(t.corner_radius_mm) +
                                                          " would begin beyond the axis; at most " + mm(largest) +
                                                          " is possible, which is a ball tip");
  return Done{};
}

Outcome check_circle_segment(double diameter_mm, double profile_radius_mm, double corner_radius_mm, double length_mm) {
  if (Outcome good = check_length("diameter", diameter_mm); !good) return good;
  if (Outcome good = check_length("profile_radius", profile_radius_mm); !good) return good;
  if (Outcome good = check_corner_radius(corner_radius_mm, diameter_mm); !good) return good;
  if (Outcome good = check_length("length", length_mm); !good) return good;
  if (profile_radius_mm < diameter_mm / 2 * (1 - kRelativeSlack))
    return contradict("profile_radius " + mm(profile_radius_mm) + " is less than half the diameter; at least " +
                      mm(diameter_mm / 2) + " is needed");
  return Done{};
}

}  // namespace

double ball_height_mm(const LollipopCutter& t) {
  const double r = t.diameter_mm / 2, neck = t.neck_diameter_mm / 2;
  return r + std::sqrt(std::max(0.0, (r - neck) * (r + neck)));
}

Result<Profile> make_shape(const LollipopCutter& t) {
  if (Outcome good = check_length("diameter", t.diameter_mm); !good) return good.error();
  if (Outcome good = check_not_negative("neck_diameter", t.neck_diameter_mm); !good) return good.error();
  if (Outcome good = check_not_negative("length", t.length_mm); !good) return good.error();
  if (!(t.neck_diameter_mm > 0) && !(t.length_mm > 0))
    return contradict("a lollipop needs a neck_diameter, or the length at which its ball ends");
  if (t.neck_diameter_mm >= t.diameter_mm)
    return contradict("neck_diameter " + mm(t.neck_diameter_mm) + " is not less than diameter " + mm(t.diameter_mm) +
                      ", that of the ball");
  const double r = t.diameter_mm / 2, top = t.length_mm > 0 ? t.length_mm : ball_height_mm(t);
  if (!(top > r && top < t.diameter_mm))
    return contradict("length " + mm(top) + " does not end within the upper half of the ball; it must lie between " +
                      mm(r) + " and " + mm(t.diameter_mm));
  ContourMaker contour(Vec2::Zero(), t.diameter_mm);
  contour.arc_to({std::sqrt((2 * r - top) * top), top}, {0, r}, r);
  return contour.close("ball and neck");
}

Result<Profile> make_shape(const BarrelCutter& t) {
  if (Outcome good = check_barrel(t); !good) return good.error();
  const Flank flank = flank_of(t);
  const double c = std::min(t.corner_radius_mm, flank.largest_corner_mm());
  ContourMaker contour(Vec2::Zero(), std::max(t.length_mm, t.diameter_mm));
  if (c > 0) {
    const double reach = flank.radius_mm - c, height = c - flank.center.y();
    const double x = flank.center.x() + std::sqrt(std::max(0.0, (reach - height) * (reach + height)));
    const Vec2 center(std::max(x, 0.0), c);
    const Vec2 touch = flank.center + flank.radius_mm * (center - flank.center).normalized();
    if (touch.y() >= t.length_mm) return too_short(t.length_mm, "the tip", touch.y());
    contour.line_to({center.x(), 0});
    contour.arc_to(touch, center, c);
  } else {
    contour.line_to({flank.radius_at(0), 0});
  }
  contour.arc_to({flank.radius_at(t.length_mm), t.length_mm}, flank.center, flank.radius_mm);
  return contour.close("tip, corner and flank");
}

Result<Profile> make_shape(const OvalCutter& t) {
  if (Outcome good = check_circle_segment(t.diameter_mm, t.profile_radius_mm, t.corner_radius_mm, t.length_mm); !good)
    return good.error();
  if (Outcome good = check_length("corner_radius", t.corner_radius_mm); !good) return good.error();
  const double r = t.corner_radius_mm, side = t.diameter_mm / 2;
  const double reach = t.profile_radius_mm - r, inset = t.profile_radius_mm - side;
  const Vec2 center(side - t.profile_radius_mm, r + std::sqrt(std::max(0.0, (reach - inset) * (reach + inset))));
  const Vec2 ball(0, r);
  const Vec2 touch = reach > 0 ? Vec2(center + t.profile_radius_mm / reach * (ball - center)) : Vec2(side, r);
  if (touch.y() >= t.length_mm) return too_short(t.length_mm, "the tip", touch.y());
  ContourMaker contour(Vec2::Zero(), std::max(t.length_mm, t.diameter_mm));
  contour.arc_to(touch, ball, r);
  const Flank flank{center, t.profile_radius_mm};
  if (t.length_mm < center.y())
    contour.arc_to({flank.radius_at(t.length_mm), t.length_mm}, center, t.profile_radius_mm);
  else
    contour.arc_to({side, center.y()}, center, t.profile_radius_mm);
  if (t.length_mm > center.y()) contour.line_to({side, t.length_mm});
  return contour.close("tip, flank and side");
}

Result<Profile> make_shape(const LensCutter& t) {
  if (Outcome good = check_circle_segment(t.diameter_mm, t.profile_radius_mm, t.corner_radius_mm, t.length_mm); !good)
    return good.error();
  const double c = t.corner_radius_mm, side = t.diameter_mm / 2, big = t.profile_radius_mm;
  const double reach = big - c, inset = side - c;
  const Vec2 top(0, big);
  const Vec2 center(inset, big - std::sqrt(std::max(0.0, (reach - inset) * (reach + inset))));
  const Vec2 touch = reach > 0 ? Vec2(top + big / reach * (center - top)) : Vec2(side, big);
  if (center.y() >= t.length_mm) return too_short(t.length_mm, "the tip", center.y());
  ContourMaker contour(Vec2::Zero(), std::max(t.length_mm, t.diameter_mm));
  contour.arc_to(touch, top, big);
  if (c > 0 && reach > 0) contour.arc_to({side, center.y()}, center, c);
  contour.line_to({side, t.length_mm});
  return contour.close("bottom, corner and side");
}

}  // namespace gouge::detail
