#include <cmath>
#include <numbers>

#include "lib/base/tolerance.h"
#include "postproc/gcode/heidenhain/klartext_runner.h"

// Motions along arcs.

namespace gouge {
namespace {

// Ends of a circle that meet but for the rounding of frames.
constexpr double kMeet_mm = Tolerance::kSamePoint_mm;

}  // namespace

void KlartextRunner::run_arc(const PathWords& words, const ProgramArc& arc, const Target& to) {
  const bool is_turning = words.has_rotary(), is_of_machine = words.function(KlartextMeaning::machine_place) != nullptr;
  const std::string open = !to.open.empty() ? to.open
                           : is_of_machine  ? "an arc to a place of the machine"
                           : is_turning     ? "no manual states how rotary axes turn along an arc"
                           : words.is_rapid ? "an arc at rapid traverse"
                                            : why_corner_open();
  if (!open.empty()) return run_unchecked(MoveKind::arc, to, open);
  ProgramArc made = arc;
  made.centre = frame_.outside(arc.centre);
  if (frame_.is_mirrored()) made.axis = -made.axis;
  AxisPlace end = to.place;
  end.xyz = frame_.outside(end.xyz);
  const Vec3 radius = to.place.xyz - arc.centre;
  const double size = radius.head<2>().norm(), turn = arc.axis.z();
  tangent_.reset();
  if (size > 0 && std::abs(to.place.xyz.z() - place().z()) <= kMeet_mm)
    tangent_ = Direction{-turn * radius.y() / size, turn * radius.x() / size};
  motion_.go_round(end, made);
}

void KlartextRunner::run_read_arc(const PathWords& words, const ArcWords& arc, Target to) {
  const Vec3 start = place();
  if ((to.place.xyz - start).head<2>().norm() <= kMeet_mm) to.place.xyz.head<2>() = start.head<2>();
  if (to.open.empty() && (start.hasNaN() || to.place.xyz.hasNaN()))
    to.open = "the place at which the arc begins or ends is not known";
  ArcReading read;
  if (to.open.empty()) read = read_program_arc(arc, start, to.place.xyz);
  if (to.open.empty()) to.open = read.open;
  run_arc(words, read.arc, to);
}

void KlartextRunner::set_pole(const PathWords& words) {
  if (words.xyz[2] || words.has_rotary() || !words.functions.empty() || words.feed || words.is_rapid)
    return lose_rest("CC is read with X and Y alone");
  polar_.reset();
  const Vec3 from = place();
  std::array<double, 2> made{};
  const bool is_here = !words.has_linear();
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& word = words.xyz.at(i);
    const double own = from[static_cast<int>(i)];
    // An axis that is left out keeps a value that no manual at hand states.
    const bool is_open = is_moved_.at(i) && (is_here || (word && word->is_step));  // as the first step after a shift
    made.at(i) = is_open   ? kUnknownValue
                 : is_here ? own
                 : !word   ? kUnknownValue
                           : length(word->value) + (word->is_step ? own : 0);
  }
  pole_ = made;
}

void KlartextRunner::go_about_pole(const PathWords& words) {
  begin_motion(words);
  polar_.reset();
  Target to = target(words);
  ArcWords arc;
  arc.is_centre_absolute = true;
  if (words.xyz[2]) to.open = "C with a third axis is not read";
  if (!words.is_clockwise && to.open.empty()) to.open = "C states no direction";
  if (!pole_ && to.open.empty()) to.open = "the pole is not known";
  if (pole_) arc.centre_mm = {(*pole_)[0], (*pole_)[1], std::nullopt};
  if (pole_ && !(is_known((*pole_)[0]) && is_known((*pole_)[1])) && to.open.empty()) to.open = "the pole is not known";
  arc.is_clockwise = words.is_clockwise.value_or(false);
  run_read_arc(words, arc, to);
  end_motion(words);
}

void KlartextRunner::go_by_radius(const PathWords& words) {
  begin_motion(words);
  polar_.reset();
  Target to = target(words);
  ArcWords arc;
  if (words.xyz[2]) to.open = "CR with a third axis is not read";
  if ((!words.is_clockwise || !words.radius) && to.open.empty()) to.open = "CR states no direction or no radius";
  arc.radius_mm = length(words.radius.value_or(kUnknownValue));
  if (!is_known(*arc.radius_mm) && to.open.empty()) to.open = "the radius of CR is not known";
  arc.is_clockwise = words.is_clockwise.value_or(false);
  run_read_arc(words, arc, to);
  end_motion(words);
}

// An arc about the pole to an angle. With a step the angle is that of the whole motion, so that a helix has all its turns.
void KlartextRunner::go_polar_arc(const PathWords& words) {
  begin_motion(words);
  Target to = target(words);
  const Vec3 start = place();
  const std::array<double, 2> pole = pole_.value_or(std::array<double, 2>{kUnknownValue, kUnknownValue});
  const double u = start.x() - pole[0], v = start.y() - pole[1], radius = std::sqrt(u * u + v * v);
  const double from_deg = std::atan2(v, u) / kDegree_rad;
  const auto angle = words.polar_angle;
  constexpr double kMaxAngle_deg = 5400;  // input range of CP
  if (words.polar_radius || words.xyz[0] || words.xyz[1]) to.open = "CP states more than its angle and the third axis";
  if (!angle || !words.is_clockwise) to.open = "CP states no angle or no direction";
  if (to.open.empty() && !(radius > 0 && std::abs(angle->value) <= kMaxAngle_deg))
    to.open = "the pole, the start or the angle of CP is not known";
  constexpr double kTurn_deg = 360;
  if (to.open.empty() && !angle->is_step && std::abs(angle->value) > kTurn_deg)
    to.open = "no manual states whether PA counts the turns beyond the first; expected IPA";
  double sweep_deg = kUnknownValue;
  if (to.open.empty()) {
    sweep_deg = angle->is_step ? angle->value : std::remainder(angle->value - from_deg, 360);
    const double wanted = *words.is_clockwise ? -1 : 1;
    if (!angle->is_step && sweep_deg * wanted < 0) sweep_deg += 360 * wanted;
    constexpr double kMinAngle_deg = 0.006;  // ends that nearly meet: a full circle, or none
    const bool is_doubtful =
        std::abs(sweep_deg) < kMinAngle_deg || (!angle->is_step && std::abs(sweep_deg) > 360 - kMinAngle_deg);
    if (sweep_deg * wanted < 0) to.open = "the signs of IPA and DR of CP differ";
    if (is_doubtful) to.open = "the ends of CP nearly meet";
  }
  const double end_rad = (from_deg + sweep_deg) * kDegree_rad;
  to.place.xyz.x() = pole[0] + radius * std::cos(end_rad);
  to.place.xyz.y() = pole[1] + radius * std::sin(end_rad);
  polar_ = Polar{radius, from_deg + sweep_deg};
  is_moved_[0] = is_moved_[1] = false;
  ProgramArc arc;
  arc.centre = Vec3(pole[0], pole[1], start.z());
  arc.axis = Vec3(0, 0, sweep_deg < 0 ? -1 : 1);
  arc.sweep_rad = std::abs(sweep_deg) * kDegree_rad;
  if (to.open.empty() && to.place.xyz.hasNaN()) to.open = "the place at which the arc begins or ends is not known";
  run_arc(words, arc, to);
  end_motion(words);
}

void KlartextRunner::go_tangentially(const PathWords& words, bool is_polar) {
  begin_motion(words);
  if (!is_polar) polar_.reset();
  Target to = is_polar ? polar_target(words) : target(words);
  const Vec3 start = place();
  const double du = to.place.xyz.x() - start.x(), dv = to.place.xyz.y() - start.y();
  if (words.xyz[2]) to.open = "CT with a third axis is not read";
  if (!tangent_ && to.open.empty()) to.open = "the direction in which CT begins is not known";
  const Direction along = tangent_.value_or(Direction{kUnknownValue, kUnknownValue});
  const double aside = along.x * dv - along.y * du, chord = std::sqrt(du * du + dv * dv);
  constexpr double kStraight = 1e-6;  // sine of the angle between chord and tangent
  if (!(std::abs(aside) > kStraight * chord) && to.open.empty())
    to.open = "CT ends in the direction in which it begins";
  const double radius = chord * chord / (2 * aside);  // to the left
  ArcWords arc;
  arc.is_centre_absolute = true;
  arc.centre_mm = {start.x() - along.y * radius, start.y() + along.x * radius, std::nullopt};
  arc.is_clockwise = radius < 0;
  run_read_arc(words, arc, to);
  end_motion(words);
}

}  // namespace gouge
