#include <algorithm>
#include <cmath>

#include "lib/base/number_text.h"
#include "toolmodels/cutter_shapes.h"

// Contours of the cutters that are polygons with rounded corners.

namespace gouge::detail {
namespace {

double cotangent(double degrees) { return cosine(degrees) / sine(degrees); }

bool is_below(double value, double limit) { return value < limit * (1 - kRelativeSlack); }

Outcome check_slot_corners(const TSlotCutter& t) {
  if (Outcome good = check_corner_radius(t.corner_radius_mm, t.diameter_mm); !good) return good;
  if (Outcome good = check_not_negative("upper_radius", t.upper_radius_mm); !good) return good;
  if (is_below(t.diameter_mm / 2, t.upper_radius_mm))
    return make_error("tool-corner-radius-too-large", "upper_radius " + mm(t.upper_radius_mm) +
                                                          " is larger than half the diameter; at most " +
                                                          mm(t.diameter_mm / 2) + " is possible");
  if (is_below(t.length_mm, t.corner_radius_mm + t.upper_radius_mm))
    return make_error("tool-corner-radius-too-large", "corner_radius " + mm(t.corner_radius_mm) + " and upper_radius " +
                                                          mm(t.upper_radius_mm) + " do not fit into the length " +
                                                          mm(t.length_mm) + "; together they may be as large as that");
  return Done{};
}

Outcome check_recess(const FaceMillCutter& t) {
  if (Outcome good = check_not_negative("recess_diameter", t.recess_diameter_mm); !good) return good;
  if (Outcome good = check_not_negative("recess_depth", t.recess_depth_mm); !good) return good;
  if ((t.recess_diameter_mm > 0) != (t.recess_depth_mm > 0))
    return contradict("recess_diameter and recess_depth belong together; give both, or neither");
  if (t.recess_depth_mm >= t.length_mm)
    return contradict("recess_depth " + mm(t.recess_depth_mm) + " goes through the cutter, whose length is " +
                      mm(t.length_mm) + "; it must be less");
  return Done{};
}

// Returns the upper end of the leaning edge of a face mill.
Vec2 edge_top(const FaceMillCutter& t) {
  const double largest = std::max(t.largest_diameter_mm, t.diameter_mm);
  if (!(t.taper_angle_deg > 0)) return {largest / 2, 0};
  return {largest / 2, (largest - t.diameter_mm) / 2 * cotangent(t.taper_angle_deg)};
}

Outcome check_edge(const FaceMillCutter& t) {
  if (Outcome good = check_not_negative("largest_diameter", t.largest_diameter_mm); !good) return good;
  const bool has_taper = std::abs(t.taper_angle_deg) > 0;
  if (has_taper)
    if (Outcome good = check_angle("taper_angle", t.taper_angle_deg, 0, 90); !good) return good;
  if (t.largest_diameter_mm > 0 && is_below(t.largest_diameter_mm, t.diameter_mm))
    return contradict("largest_diameter " + mm(t.largest_diameter_mm) + " is less than diameter " + mm(t.diameter_mm) +
                      "; it must be at least that");
  const bool is_wider = t.largest_diameter_mm > t.diameter_mm * (1 + kRelativeSlack);
  if (has_taper != is_wider)
    return contradict("an edge with a taper_angle needs a largest_diameter greater than diameter " + mm(t.diameter_mm) +
                      ", and the other way round; give both, or neither");
  if (is_below(t.length_mm, edge_top(t).y())) return too_short(t.length_mm, "the leaning edge", edge_top(t).y());
  return Done{};
}

// Returns the distance from a corner of `between_deg` degrees to the points where an arc of this radius touches its
// sides.
double trim(double radius_mm, double between_deg) { return radius_mm * cotangent(between_deg / 2); }

Outcome check_face_corner(const FaceMillCutter& t) {
  const double recess = t.recess_diameter_mm / 2, edge = edge_top(t).y() / cosine(t.taper_angle_deg);
  const double space_above = t.taper_angle_deg > 0 ? edge : t.length_mm;
  const double room = std::min(t.diameter_mm / 2 - recess, space_above);
  const double taken = trim(t.corner_radius_mm, 90 + t.taper_angle_deg);
  if (!(taken > room * (1 + kRelativeSlack))) return Done{};
  return make_error("tool-corner-radius-too-large", "corner_radius " + mm(t.corner_radius_mm) +
                                                        " has no room between the underside and the edge; at most " +
                                                        mm(room * t.corner_radius_mm / taken) + " is possible");
}

}  // namespace

double cone_height_mm(const ChamferCutter& t) {
  return (t.diameter_mm - t.tip_diameter_mm) / 2 * cotangent(t.taper_angle_deg);
}

Result<Profile> make_shape(const DrillCutter& t) {
  if (Outcome good = check_length("diameter", t.diameter_mm); !good) return good.error();
  if (Outcome good = check_length("length", t.length_mm); !good) return good.error();
  if (!(t.point_angle_deg > 0 && t.point_angle_deg <= 180))
    return make_error(
        "tool-angle-out-of-range",
        "point_angle is " +
            (std::isfinite(t.point_angle_deg) ? exact_text(t.point_angle_deg) + " degrees" : "not a number") +
            "; the included angle of the point must lie above 0 and be 180 at most");
  const double r = t.diameter_mm / 2, point = r * cotangent(t.point_angle_deg / 2);
  if (is_below(t.length_mm, point)) return too_short(t.length_mm, "the point", point);
  return make_rounded({{{0, 0}, 0}, {{r, point}, 0}, {{r, t.length_mm}, 0}}, "point and side");
}

Result<Profile> make_shape(const ChamferCutter& t) {
  if (Outcome good = check_length("diameter", t.diameter_mm); !good) return good.error();
  if (Outcome good = check_not_negative("tip_diameter", t.tip_diameter_mm); !good) return good.error();
  if (Outcome good = check_angle("taper_angle", t.taper_angle_deg, 0, 90); !good) return good.error();
  if (Outcome good = check_not_negative("length", t.length_mm); !good) return good.error();
  if (t.tip_diameter_mm >= t.diameter_mm)
    return contradict("tip_diameter " + mm(t.tip_diameter_mm) + " is not less than diameter " + mm(t.diameter_mm) +
                      ", which is the largest");
  const double r = t.diameter_mm / 2, cone = cone_height_mm(t);
  if (t.length_mm > 0 && is_below(t.length_mm, cone)) return too_short(t.length_mm, "the cone", cone);
  const double top = t.length_mm > 0 ? t.length_mm : cone;
  return make_rounded({{{0, 0}, 0}, {{t.tip_diameter_mm / 2, 0}, 0}, {{r, cone}, 0}, {{r, top}, 0}}, "cone and side");
}

Result<Profile> make_shape(const TSlotCutter& t) {
  if (Outcome good = check_length("diameter", t.diameter_mm); !good) return good.error();
  if (Outcome good = check_length("length", t.length_mm); !good) return good.error();
  if (Outcome good = check_slot_corners(t); !good) return good.error();
  const double r = t.diameter_mm / 2;
  return make_rounded(
      {{{0, 0}, 0}, {{r, 0}, t.corner_radius_mm}, {{r, t.length_mm}, t.upper_radius_mm}, {{0, t.length_mm}, 0}},
      "disc with rounded corners");
}

Result<Profile> make_shape(const SlittingSawCutter& t) {
  if (Outcome good = check_length("diameter", t.diameter_mm); !good) return good.error();
  if (Outcome good = check_length("thickness", t.thickness_mm); !good) return good.error();
  if (Outcome good = check_not_negative("cap_diameter", t.cap_diameter_mm); !good) return good.error();
  if (Outcome good = check_not_negative("cap_height", t.cap_height_mm); !good) return good.error();
  if ((t.cap_diameter_mm > 0) != (t.cap_height_mm > 0))
    return contradict("cap_diameter and cap_height belong together; give both, or neither");
  if (t.cap_diameter_mm >= t.diameter_mm)
    return contradict("cap_diameter " + mm(t.cap_diameter_mm) + " is not less than diameter " + mm(t.diameter_mm) +
                      "; the cap would cover the blade");
  const double r = t.diameter_mm / 2, cap = t.cap_diameter_mm / 2, low = t.cap_height_mm;
  return make_rounded({{{0, 0}, 0}, {{cap, 0}, 0}, {{cap, low}, 0}, {{r, low}, 0}, {{r, low + t.thickness_mm}, 0}},
                      "cap and blade");
}

Result<Profile> make_shape(const FaceMillCutter& t) {
  if (Outcome good = check_length("diameter", t.diameter_mm); !good) return good.error();
  if (Outcome good = check_length("length", t.length_mm); !good) return good.error();
  if (Outcome good = check_corner_radius(t.corner_radius_mm, t.diameter_mm); !good) return good.error();
  if (Outcome good = check_edge(t); !good) return good.error();
  if (Outcome good = check_recess(t); !good) return good.error();
  if (t.recess_diameter_mm >= t.diameter_mm)
    return contradict("recess_diameter " + mm(t.recess_diameter_mm) + " is not less than diameter " +
                      mm(t.diameter_mm));
  if (Outcome good = check_face_corner(t); !good) return good.error();
  const double recess = t.recess_diameter_mm / 2, deep = t.recess_depth_mm;
  const Vec2 top = edge_top(t);
  return make_rounded({{{0, deep}, 0},
                       {{recess, deep}, 0},
                       {{recess, 0}, 0},
                       {{t.diameter_mm / 2, 0}, t.corner_radius_mm},
                       {{top.x(), t.taper_angle_deg > 0 ? top.y() : t.length_mm}, 0},
                       {{top.x(), t.length_mm}, 0},
                       {{0, t.length_mm}, 0}},
                      "underside, edge and side");
}

Result<Profile> make_shape(const RadiusCutter& t) {
  if (Outcome good = check_length("tip_diameter", t.tip_diameter_mm); !good) return good.error();
  if (Outcome good = check_not_negative("tip_length", t.tip_length_mm); !good) return good.error();
  if (Outcome good = check_length("profile_radius", t.profile_radius_mm); !good) return good.error();
  if (Outcome good = check_not_negative("diameter", t.diameter_mm); !good) return good.error();
  if (Outcome good = check_length("length", t.length_mm); !good) return good.error();
  const double tip = t.tip_diameter_mm / 2, r = t.profile_radius_mm, end = tip + r;
  const double top = t.tip_length_mm + r;
  if (t.diameter_mm > 0 && is_below(t.diameter_mm, 2 * end))
    return contradict("diameter " + mm(t.diameter_mm) + " is less than tip_diameter and two profile_radius together, " +
                      mm(2 * end) + "; it must be at least that");
  if (is_below(t.length_mm, top)) return too_short(t.length_mm, "the arc", top);
  const double wide = std::max(t.diameter_mm / 2, end);
  return make_rounded(
      {{{0, 0}, 0}, {{tip, 0}, 0}, {{tip, top}, r}, {{wide, top}, 0}, {{wide, t.length_mm}, 0}, {{0, t.length_mm}, 0}},
      "tip, arc and side");
}

}  // namespace gouge::detail
