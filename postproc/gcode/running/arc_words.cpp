#include "postproc/gcode/running/arc_words.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gouge {
namespace {

constexpr double kWhole_rad = 2 * std::numbers::pi;
// Radii at both ends may differ by the rounding of a program in inches with four decimals, and by a thousandth.
constexpr double kRadiusDifference_mm = 0.01, kRadiusShare = 0.001, kMaxRadiusDifference_mm = 0.2;
// Ends of an arc that nearly meet: by the rounding of its numbers it is a full circle, or none.
constexpr double kNearlyMeet_rad = 1e-4;
constexpr double kMaxTurns = 1000;
constexpr double kMeet_mm = 1e-6;  // below the last digit of any program

struct InPlane {
  double u = 0, v = 0;
};

double length_of(double u, double v) { return std::sqrt(u * u + v * v); }

InPlane in_plane(const Vec3& point, const PlaneAxes& plane) { return {point[plane[0]], point[plane[1]]}; }

ArcReading unknown_arc(std::string reason) { return {{}, std::move(reason)}; }

/// Returns the centre of an arc by its radius. None: its ends are farther apart than the diameter.
std::optional<InPlane> centre_by_radius(const ArcWords& of, InPlane from, InPlane to) {
  const double du = to.u - from.u, dv = to.v - from.v, chord = length_of(du, dv), radius = std::abs(*of.radius_mm);
  const double over = chord / 2 - radius;
  if (!(chord > 0) || over > std::min(kRadiusDifference_mm, kRadiusShare * radius)) return std::nullopt;
  const double height = std::sqrt(std::max(0.0, radius * radius - chord * chord / 4));
  // Left of the chord for the shorter arc counterclockwise, and for the longer one clockwise.
  const double side = of.is_clockwise == (*of.radius_mm < 0) ? height : -height;
  return InPlane{from.u + du / 2 - dv / chord * side, from.v + dv / 2 + du / chord * side};
}

std::optional<InPlane> centre_by_words(const ArcWords& of, InPlane from) {
  const auto& u = of.centre_mm.at(static_cast<std::size_t>(of.plane[0]));
  const auto& v = of.centre_mm.at(static_cast<std::size_t>(of.plane[1]));
  if ((!u && !v) || of.centre_mm.at(static_cast<std::size_t>(of.plane[2]))) return std::nullopt;
  if (of.is_centre_absolute) return u && v ? std::optional(InPlane{*u, *v}) : std::nullopt;
  return InPlane{from.u + u.value_or(0), from.v + v.value_or(0)};
}

}  // namespace

ArcReading read_program_arc(const ArcWords& of, const Vec3& start, const Vec3& end) {
  const InPlane from = in_plane(start, of.plane), to = in_plane(end, of.plane);
  const auto is_given = [](const std::optional<double>& word) { return word.has_value(); };
  const bool has_centre = std::ranges::any_of(of.centre_mm, is_given);
  if (of.radius_mm && has_centre) return unknown_arc("an arc has both R and a centre");
  if (of.turns < 1 || of.turns > kMaxTurns) return unknown_arc("the number of turns of an arc is not understood");
  const auto centre = of.radius_mm ? centre_by_radius(of, from, to) : centre_by_words(of, from);
  if (!centre)
    return unknown_arc(of.radius_mm ? "no arc of this radius joins both ends"
                                    : "an arc needs its centre by the two words of its plane, or R");
  const double r0 = length_of(from.u - centre->u, from.v - centre->v),
               r1 = length_of(to.u - centre->u, to.v - centre->v), apart = std::abs(r1 - r0);
  if (!(r0 > 0) || !(r1 > 0)) return unknown_arc("the centre of an arc is at one of its ends");
  if (apart > kMaxRadiusDifference_mm || (apart > kRadiusDifference_mm && apart > kRadiusShare * std::max(r0, r1)))
    return unknown_arc("the ends of an arc are not equally far from its centre");
  const double a0 = std::atan2(from.v - centre->v, from.u - centre->u),
               a1 = std::atan2(to.v - centre->v, to.u - centre->u);
  double sweep = of.is_clockwise ? a0 - a1 : a1 - a0;
  if (sweep < 0) sweep += kWhole_rad;
  const bool do_meet = std::abs(from.u - to.u) + std::abs(from.v - to.v) <= kMeet_mm;
  if (do_meet)
    sweep = kWhole_rad;
  else if (sweep < kNearlyMeet_rad || sweep > kWhole_rad - kNearlyMeet_rad)
    return unknown_arc("the ends of an arc nearly meet, so that it may be a full circle or none");
  ProgramArc arc;
  arc.centre = start;
  arc.centre[of.plane[0]] = centre->u;
  arc.centre[of.plane[1]] = centre->v;
  arc.axis = Vec3::Zero();
  arc.axis[of.plane[2]] = of.is_clockwise ? -1 : 1;
  arc.sweep_rad = sweep + kWhole_rad * (of.turns - 1);
  return {arc, {}};
}

}  // namespace gouge
