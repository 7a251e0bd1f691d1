#include <cmath>
#include <numbers>

#include "lib/base/number_text.h"
#include "toolmodels/cutter_shapes.h"

namespace gouge {

Outcome check_length(const std::string& field, double value_mm) {
  if (!(value_mm > 0))
    return make_error("tool-dimension-not-positive",
                      field + " is " + (std::isfinite(value_mm) ? detail::mm(value_mm) : "not a number") +
                          "; it must be greater than 0");
  if (!(value_mm <= detail::kLargest_mm))
    return make_error("tool-dimension-too-large", field + " is larger than 100000 mm; check the unit of the file");
  return Done{};
}

}  // namespace gouge

namespace gouge::detail {

std::string mm(double value_mm) { return exact_text(std::round(value_mm * 1e9) / 1e9) + " mm"; }

double radians(double degrees) { return degrees * (std::numbers::pi / 180); }

double sine(double degrees) { return std::sin(radians(degrees)); }

double cosine(double degrees) { return sine(90 - std::abs(degrees)); }

Outcome check_not_negative(const std::string& field, double value_mm) {
  if (value_mm > 0) return check_length(field, value_mm);
  if (value_mm >= 0) return Done{};
  return make_error(
      "tool-dimension-negative",
      field + " is " + (std::isfinite(value_mm) ? mm(value_mm) : "not a number") + "; it must not be negative");
}

Outcome check_angle(const std::string& field, double value_deg, double low_deg, double high_deg) {
  if (value_deg > low_deg && value_deg < high_deg) return Done{};
  const std::string found = std::isfinite(value_deg) ? exact_text(value_deg) + " degrees" : "not a number";
  return make_error("tool-angle-out-of-range", field + " is " + found + "; it must lie between " + exact_text(low_deg) +
                                                   " and " + exact_text(high_deg));
}

Outcome check_corner_radius(double radius_mm, double diameter_mm) {
  if (!(radius_mm >= 0))
    return make_error("tool-corner-radius-negative", "corner_radius is " +
                                                         (std::isfinite(radius_mm) ? mm(radius_mm) : "not a number") +
                                                         "; give 0 for a sharp corner, or a positive radius");
  if (radius_mm > diameter_mm / 2 * (1 + kRelativeSlack))
    return make_error("tool-corner-radius-too-large", "corner_radius " + mm(radius_mm) +
                                                          " is larger than half the diameter; at most " +
                                                          mm(diameter_mm / 2) + " is possible");
  return Done{};
}

Diagnostic too_short(double length_mm, const std::string& what, double at_min_mm) {
  return make_error("tool-length-too-short", "length " + mm(length_mm) + " ends within " + what +
                                                 ", which reaches up to z = " + mm(at_min_mm) +
                                                 "; give a greater length");
}

Diagnostic contradict(const std::string& message) { return make_error("tool-dimensions-contradict", message); }

void ContourMaker::line_to(const Vec2& to) {
  if (is_here(to)) {
    if (!profile_.elements.empty()) profile_.elements.back().b = at_ = to;
    return;
  }
  profile_.elements.push_back(make_segment(Body::cutter, at_, to));
  at_ = to;
}

void ContourMaker::arc_to(const Vec2& to, const Vec2& center, double radius_mm, bool is_concave) {
  if (is_here(to)) return;
  profile_.elements.push_back(is_concave ? make_concave_arc(Body::cutter, at_, to, center, radius_mm)
                                         : make_convex_arc(Body::cutter, at_, to, center, radius_mm));
  at_ = to;
}

Result<Profile> ContourMaker::close(const std::string& what) {
  if (at_.x() > 0) line_to({0, at_.y()});
  if (const std::vector<std::string> broken = verify_profile(profile_); !broken.empty())
    return make_error("tool-no-closed-profile",
                      "these numbers make no closed profile: " + broken.front() + " (" + what + ")");
  return std::move(profile_);
}

Result<Profile> make_rounded(const std::vector<RoundedCorner>& corners, const std::string& what) {
  double size = 0;
  for (const RoundedCorner& c : corners) size = std::max({size, c.at.x(), std::abs(c.at.y())});
  ContourMaker contour(corners.front().at, size);
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const RoundedCorner& c = corners[i];
    if (!(c.radius_mm > 0) || i + 1 == corners.size()) {
      contour.line_to(c.at);
      continue;
    }
    const Vec2 in = (c.at - corners[i - 1].at).normalized(), out = (corners[i + 1].at - c.at).normalized();
    const double turn = in.x() * out.y() - in.y() * out.x();
    const double trim = c.radius_mm * std::abs(turn) / (1 + in.dot(out));
    const Vec2 from = c.at - trim * in, to = c.at + trim * out;
    const Vec2 inward = turn > 0 ? Vec2(-in.y(), in.x()) : Vec2(in.y(), -in.x());
    contour.line_to(from);
    contour.arc_to(to, from + c.radius_mm * inward, c.radius_mm, turn < 0);
  }
  return contour.close(what);
}

}  // namespace gouge::detail
