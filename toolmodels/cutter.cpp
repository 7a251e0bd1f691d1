#include "toolmodels/cutter.h"

#include <cmath>
#include <numbers>
#include <optional>

#include "lib/base/number_text.h"

namespace gouge {
namespace {

constexpr double kLargest_mm = 1e5;      // keeps every later square far from overflow
constexpr double kRelativeSlack = 1e-9;  // dimensions closer than this to a limit are at the limit

std::string mm(double value) {
  return exact_text(std::round(value * 1e9) / 1e9) + " mm";
}

bool is_plain(const AptCutter& t) {
  return !(t.alpha_deg > 0) && !(t.beta_deg > 0) && !(t.beta_deg < 0);
}

double radians(double degrees) {
  return degrees * (std::numbers::pi / 180);
}

double sine(double degrees) {
  return std::sin(radians(degrees));
}

double cosine(double degrees) {
  return sine(90 - std::abs(degrees));
}  // exact at 0

// What every shape here comes down to: the bottom line at alpha, the corner arc, the side at beta.
struct Corner {
  Vec2 center;
  double radius_mm;
  double alpha_deg, beta_deg;
  double length_mm;
};

Outcome check_corner(const Corner& corner, const Vec2& low, const Vec2& high) {
  const double size = std::max(corner.length_mm, high.x());
  if (low.x() < -kRelativeSlack * size || high.x() <= 0 || high.y() < low.y() - kRelativeSlack * size)
    return make_error("tool-no-closed-profile",
                      "these numbers make no closed profile: the corner arc of radius " +
                          mm(corner.radius_mm) + " would begin at r = " + mm(low.x()) + " and end at r = " +
                          mm(high.x()) + "; give a larger diameter or a smaller corner radius");
  if (corner.length_mm <= high.y() * (1 + kRelativeSlack))
    return make_error("tool-length-too-short", "length " + mm(corner.length_mm) +
                                                   " ends within the tip, which reaches up to z = " +
                                                   mm(high.y()) + "; give a greater length");
  return Done{};
}

void add_segment(Profile& profile, const Vec2& a, const Vec2& b, double size) {
  if ((b - a).norm() <= kRelativeSlack * size) {
    if (!profile.elements.empty()) profile.elements.back().b = b;
    return;
  }
  profile.elements.push_back(make_segment(Body::cutter, a, b));
}

Result<Profile> make_from_corner(const Corner& c) {
  const Vec2 bottom_normal(sine(c.alpha_deg), -cosine(c.alpha_deg));
  const Vec2 side_normal(cosine(c.beta_deg), -sine(c.beta_deg));
  Vec2 low = c.center + c.radius_mm * bottom_normal;
  Vec2 high = c.center + c.radius_mm * side_normal;
  if (Outcome good = check_corner(c, low, high); !good) return good.error();
  const double size = std::max(c.length_mm, high.x());
  if (low.x() <= kRelativeSlack * size) low.x() = 0;
  const double top_r = high.x() + (c.length_mm - high.y()) * sine(c.beta_deg) / cosine(c.beta_deg);
  if (top_r <= kRelativeSlack * size)
    return make_error("tool-taper-closes",
                      "a side leaning inward by " + exact_text(-c.beta_deg) + " degrees closes at z = " +
                          mm(high.y() - high.x() * cosine(c.beta_deg) / sine(c.beta_deg)) +
                          ", below the top of the flutes at " + mm(c.length_mm) +
                          "; give a smaller angle or a smaller length");
  if (top_r > kLargest_mm)
    return make_error("tool-angle-out-of-range", "a side leaning outward by " + exact_text(c.beta_deg) +
                                                     " degrees is " + mm(2 * top_r) +
                                                     " wide at the top of the flutes; give a smaller angle");
  Profile profile;
  const Vec2 tip = Vec2::Zero();
  add_segment(profile, tip, low, size);
  const Vec2 from = profile.elements.empty() ? tip : low;
  if ((high - from).norm() > kRelativeSlack * size)
    profile.elements.push_back(make_convex_arc(Body::cutter, from, high, c.center, c.radius_mm));
  else
    high = from;
  const Vec2 top(top_r, c.length_mm);
  add_segment(profile, high, top, size);
  profile.elements.push_back(make_segment(Body::cutter, top, Vec2(0, c.length_mm)));
  return profile;
}

Outcome check_corner_radius(double radius_mm, double diameter_mm) {
  if (!(radius_mm >= 0))
    return make_error("tool-corner-radius-negative", "corner_radius is " + mm(radius_mm) +
                                                         "; give 0 for a sharp corner, or a positive radius");
  if (radius_mm > diameter_mm / 2 * (1 + kRelativeSlack))
    return make_error("tool-corner-radius-too-large", "corner_radius " + mm(radius_mm) +
                                                          " is larger than half the diameter; at most " +
                                                          mm(diameter_mm / 2) + " is possible");
  return Done{};
}

Result<Profile> make_plain(double diameter_mm, double corner_radius_mm, double taper_deg, double length_mm) {
  if (Outcome good = check_length("diameter", diameter_mm); !good) return good.error();
  if (Outcome good = check_length("length", length_mm); !good) return good.error();
  if (Outcome good = check_corner_radius(corner_radius_mm, diameter_mm); !good) return good.error();
  if (!(taper_deg > -90 && taper_deg < 90))
    return make_error("tool-angle-out-of-range",
                      "taper_angle is " + exact_text(taper_deg) + " degrees; it must lie between -90 and 90");
  const double c = std::min(corner_radius_mm, diameter_mm / 2);
  return make_from_corner({{diameter_mm / 2 - c, c}, c, 0, taper_deg, length_mm});
}

// Centre of the circle of radius r that touches the bottom line and the side from within.
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
  if (!(t.alpha_deg >= 0 && t.alpha_deg < 90))
    return make_error("tool-angle-out-of-range",
                      "alpha is " + exact_text(t.alpha_deg) + " degrees; it must lie in [0, 90)");
  if (!(t.beta_deg > -90 && t.beta_deg < 90 - t.alpha_deg))
    return make_error("tool-angle-out-of-range", "beta is " + exact_text(t.beta_deg) +
                                                     " degrees; it must lie between -90 and " +
                                                     exact_text(90 - t.alpha_deg) + " (90 - alpha)");
  if (is_plain(t)) return check_corner_radius(t.r_mm, t.d_mm);
  return Done{};
}

Result<Profile> make_apt(const AptCutter& t) {
  if (Outcome good = check_apt(t); !good) return good.error();
  if (is_plain(t)) return make_plain(t.d_mm, t.r_mm, 0, t.h_mm);
  return make_from_corner({apt_center(t), t.r_mm, t.alpha_deg, t.beta_deg, t.h_mm});
}

struct MakeProfile {
  Result<Profile> operator()(const FlatCutter& t) const {
    return make_plain(t.diameter_mm, 0, 0, t.length_mm);
  }
  Result<Profile> operator()(const BallCutter& t) const {
    return make_plain(t.diameter_mm, t.diameter_mm / 2, 0, t.length_mm);
  }
  Result<Profile> operator()(const BullNoseCutter& t) const {
    return make_plain(t.diameter_mm, t.corner_radius_mm, 0, t.length_mm);
  }
  Result<Profile> operator()(const TaperedCutter& t) const {
    return make_plain(t.diameter_mm, t.corner_radius_mm, t.taper_angle_deg, t.length_mm);
  }
  Result<Profile> operator()(const AptCutter& t) const { return make_apt(t); }
};

}  // namespace

const char* shape_name(const Cutter& cutter) {
  constexpr const char* kNames[] = {"flat", "ball", "bull_nose", "tapered", "apt"};
  return kNames[cutter.index()];
}

double length_mm(const Cutter& cutter) {
  if (const auto* apt = std::get_if<AptCutter>(&cutter)) return apt->h_mm;
  return std::visit(
      [](const auto& t) {
        if constexpr (requires { t.length_mm; })
          return t.length_mm;
        else
          return 0.0;
      },
      cutter);
}

Result<Profile> make_cutter_profile(const Cutter& cutter) {
  return std::visit(MakeProfile{}, cutter);
}

std::string apt_contradiction(const AptCutter& t) {
  if (!check_apt(t)) return {};
  const Vec2 center = apt_center(t);
  const double slack = 1e-3 * std::max(t.d_mm, t.r_mm);  // files round to three or four digits
  const bool is_given = t.e_mm > 0 || t.e_mm < 0 || t.f_mm > 0 || t.f_mm < 0;
  const bool agrees = std::abs(t.e_mm - center.x()) <= slack && std::abs(t.f_mm - center.y()) <= slack;
  if (!is_given || agrees) return {};
  return "e = " + mm(t.e_mm) + ", f = " + mm(t.f_mm) +
         " do not place the corner where d, r, alpha and beta do (e = " + mm(center.x()) +
         ", f = " + mm(center.y()) + "); built from d, r, alpha and beta";
}

Outcome check_length(const std::string& field, double value_mm) {
  if (!(value_mm > 0))
    return make_error("tool-dimension-not-positive",
                      field + " is " + (std::isfinite(value_mm) ? mm(value_mm) : "not a number") +
                          "; it must be greater than 0");
  if (!(value_mm <= kLargest_mm))
    return make_error("tool-dimension-too-large",
                      field + " is larger than 100000 mm; check the unit of the file");
  return Done{};
}

}  // namespace gouge
