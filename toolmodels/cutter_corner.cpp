#include <algorithm>
#include <cmath>

#include "lib/base/number_text.h"
#include "lib/base/tolerance.h"
#include "toolmodels/cutter_shapes.h"

// Contours of the cutters that have one corner: a bottom line, a corner arc, a straight side.

namespace gouge::detail {
namespace {

bool is_plain(const AptCutter& t) { return std::abs(t.alpha_deg) <= 0 && std::abs(t.beta_deg) <= 0; }

// The common form of these cutters: the bottom line at the angle alpha, the corner arc, the side at the angle beta.
struct Corner {
  Vec2 center;
  double radius_mm;
  double alpha_deg, beta_deg;
  double length_mm;
};

Outcome check_corner(const Corner& corner, const Vec2& low, const Vec2& high) {
  const double size = std::max(corner.length_mm, high.x());
  const bool is_point = !(corner.radius_mm > 0) && corner.beta_deg > 0;
  if (low.x() < -kRelativeSlack * size || (high.x() <= 0 && !is_point))
    return make_error("tool-no-closed-profile", "these numbers make no closed profile: the corner arc of radius " +
                                                    mm(corner.radius_mm) + " would begin at r = " + mm(low.x()) +
                                                    " and end at r = " + mm(high.x()) +
                                                    "; give a larger diameter or a smaller corner radius");
  if (corner.length_mm < high.y() - Tolerance::kConstruction * size)
    return too_short(corner.length_mm, "the tip", high.y());
  return Done{};
}

Result<Profile> make_from_corner(const Corner& c) {
  const Vec2 bottom_normal(sine(c.alpha_deg), -cosine(c.alpha_deg));
  const Vec2 side_normal(cosine(c.beta_deg), -sine(c.beta_deg));
  Vec2 low = c.center + c.radius_mm * bottom_normal;
  Vec2 high = c.center + c.radius_mm * side_normal;
  if (Outcome good = check_corner(c, low, high); !good) return good.error();
  const double size = std::max(c.length_mm, high.x());
  if (low.x() <= kRelativeSlack * size) low.x() = 0;
  if (std::abs(c.length_mm - high.y()) <= Tolerance::kConstruction * size) high.y() = c.length_mm;
  const double top_r = high.x() + (c.length_mm - high.y()) * sine(c.beta_deg) / cosine(c.beta_deg);
  if (top_r <= kRelativeSlack * size)
    return make_error("tool-taper-closes",
                      "a side leaning inward by " + exact_text(-c.beta_deg) +
                          " degrees closes at z = " + mm(high.y() - high.x() * cosine(c.beta_deg) / sine(c.beta_deg)) +
                          ", below the top of the flutes at " + mm(c.length_mm) +
                          "; give a smaller angle or a smaller length");
  if (top_r > kLargest_mm)
    return make_error("tool-angle-out-of-range", "a side leaning outward by " + exact_text(c.beta_deg) +
                                                     " degrees is " + mm(2 * top_r) +
                                                     " wide at the top of the flutes; give a smaller angle");
  ContourMaker contour(Vec2::Zero(), size);
  contour.line_to(low);
  contour.arc_to(high, c.center, c.radius_mm);
  contour.line_to({top_r, c.length_mm});
  return contour.close("bottom, corner and side");
}

Result<Profile> make_plain(double diameter_mm, double corner_radius_mm, double taper_deg, double length_mm) {
  if (Outcome good = check_length("diameter", diameter_mm); !good) return good.error();
  if (Outcome good = check_length("length", length_mm); !good) return good.error();
  if (Outcome good = check_corner_radius(corner_radius_mm, diameter_mm); !good) return good.error();
  if (Outcome good = check_angle("taper_angle", taper_deg, -90, 90); !good) return good.error();
  const double c = std::min(corner_radius_mm, diameter_mm / 2);
  return make_from_corner({{diameter_mm / 2 - c, c}, c, 0, taper_deg, length_mm});
}

// Returns the centre of the circle of radius r that touches the bottom line and the side from within.
Vec2 apt_center(const AptCutter& t) {
  const double sa = sine(t.alpha_deg), ca = cosine(t.alpha_deg);
  const double sb = sine(t.beta_deg), cb = cosine(t.beta_deg);
  const Vec2 meet(t.d_mm / 2, t.d_mm / 2 * sa / ca);
  // Solves (sa, -ca).x = -r and (cb, -sb).x = -r for x = centre - meet.
  const double det = -sa * sb + ca * cb;
  return meet + Vec2(t.r_mm * (sb - ca), t.r_mm * (cb - sa)) / det;
}

Outcome check_apt(const AptCutter& t) {
  if (!(t.d_mm >= 0 && t.d_mm <= kLargest_mm))
    return make_error("tool-dimension-not-positive", "d is " + mm(t.d_mm) + "; it must not be negative");
  if (!(t.r_mm >= 0 && t.r_mm <= kLargest_mm))
    return make_error("tool-corner-radius-negative", "r is " + mm(t.r_mm) + "; it must not be negative");
  if (Outcome good = check_length("h", t.h_mm); !good) return good;
  if (Outcome good = check_angle("alpha", t.alpha_deg, -90, 90); !good) return good;
  // The bottom line and the side must meet at the corner.
  const double lowest = std::max(-90.0, -90 - t.alpha_deg), highest = std::min(90.0, 90 - t.alpha_deg);
  if (!(t.beta_deg > lowest && t.beta_deg < highest))
    return make_error("tool-angle-out-of-range",
                      "beta is " + (std::isfinite(t.beta_deg) ? exact_text(t.beta_deg) + " degrees" : "not a number") +
                          "; it must lie between " + exact_text(lowest) + " and " + exact_text(highest) +
                          " for alpha " + exact_text(t.alpha_deg));
  if (is_plain(t)) return check_corner_radius(t.r_mm, t.d_mm);
  return Done{};
}

}  // namespace

Result<Profile> make_shape(const FlatCutter& t) { return make_plain(t.diameter_mm, 0, 0, t.length_mm); }

Result<Profile> make_shape(const BallCutter& t) { return make_plain(t.diameter_mm, t.diameter_mm / 2, 0, t.length_mm); }

Result<Profile> make_shape(const BullNoseCutter& t) {
  return make_plain(t.diameter_mm, t.corner_radius_mm, 0, t.length_mm);
}

Result<Profile> make_shape(const TaperedCutter& t) {
  return make_plain(t.diameter_mm, t.corner_radius_mm, t.taper_angle_deg, t.length_mm);
}

Result<Profile> make_shape(const DovetailCutter& t) {
  if (Outcome good = check_angle("taper_angle", t.taper_angle_deg, 0, 90); !good) return good.error();
  return make_plain(t.diameter_mm, t.corner_radius_mm, -t.taper_angle_deg, t.length_mm);
}

Result<Profile> make_shape(const AptCutter& t) {
  if (Outcome good = check_apt(t); !good) return good.error();
  if (is_plain(t)) return make_plain(t.d_mm, t.r_mm, 0, t.h_mm);
  return make_from_corner({apt_center(t), t.r_mm, t.alpha_deg, t.beta_deg, t.h_mm});
}

}  // namespace gouge::detail

namespace gouge {

std::string apt_contradiction(const AptCutter& t) {
  using namespace detail;
  if (!check_apt(t)) return {};
  const Vec2 center = apt_center(t);
  const double slack = 1e-3 * std::max(t.d_mm, t.r_mm);  // files round to three or four digits
  const auto is_near = [&](double found, double expected) { return std::abs(found - expected) <= slack; };
  const bool is_given = std::abs(t.e_mm) > 0 || std::abs(t.f_mm) > 0;
  // Some writers state in e the diameter of the flat tip, computed as if both angles were 0.
  const bool is_tip_diameter =
      is_near(t.e_mm, t.d_mm - 2 * t.r_mm) && (is_near(t.f_mm, t.r_mm) || is_near(t.f_mm, center.y()));
  if (!is_given || is_tip_diameter || (is_near(t.e_mm, center.x()) && is_near(t.f_mm, center.y()))) return {};
  return "e = " + mm(t.e_mm) + ", f = " + mm(t.f_mm) +
         " do not place the corner where d, r, alpha and beta do (e = " + mm(center.x()) + ", f = " + mm(center.y()) +
         "); built from d, r, alpha and beta";
}

}  // namespace gouge
