#include <cmath>
#include <numbers>

#include "postproc/gcode/siemens/siemens_runner.h"

// G2 and G3 by centre, radius or opening angle, and CIP by a point between the ends.

namespace gouge {
namespace {

constexpr std::array<std::string_view, 3> kCentreWords = {"I", "J", "K"}, kPointWords = {"I1", "J1", "K1"},
                                          kAxisWords = {"X", "Y", "Z"};

/// Returns the arc from `start` over `middle` to `end`; none: they are on a line, or nearly.
std::optional<ProgramArc> arc_through(const Vec3& start, const Vec3& middle, const Vec3& end) {
  constexpr double kMinSine = 1e-4;  // of the angle at the middle
  const Vec3 a = middle - start, b = end - start, normal = a.cross(b);
  const double least = kMinSine * a.norm() * b.norm();
  if (!(normal.norm() > least) || !(normal.norm() > kMinSine * a.norm() * (end - middle).norm())) return std::nullopt;
  const Vec3 to_centre =
      (b.squaredNorm() * normal.cross(a) + a.squaredNorm() * b.cross(normal)) / (2 * normal.squaredNorm());
  ProgramArc arc;
  arc.centre = start + to_centre;
  arc.axis = normal.normalized();
  const Vec3 from = -to_centre, to = end - arc.centre;
  double sweep = std::atan2(arc.axis.dot(from.cross(to)), from.dot(to));
  if (sweep < 0) sweep += 2 * std::numbers::pi;
  arc.sweep_rad = sweep;
  return arc;
}

}  // namespace

void SiemensRunner::go_round(const SiemensRow& row, Target to) {
  const AxisPlace& from = motion_.place();
  const auto is_same = [](double a, double b) { return std::abs(a - b) <= 0 || (std::isnan(a) && std::isnan(b)); };
  const bool is_turning = !is_same(to.place.angles[0], from.angles[0]) ||
                          !is_same(to.place.angles[1], from.angles[1]) || words_.has_any({"A3", "B3", "C3"});
  if (to.open.empty() && is_turning) to.open = "the tool turns along an arc";
  if (to.open.empty() && from.xyz.hasNaN()) to.open = "the place at which the arc begins is not known";
  if (to.open.empty() && row.meaning == SiemensMeaning::arc_by_point) return go_by_point(to);
  ArcWords arc;
  if (modes_.plane)
    arc.plane = *modes_.plane;
  else if (to.open.empty())
    to.open = "nothing states the plane of the arc before it; expected --start G17";
  arc.is_clockwise = row.meaning == SiemensMeaning::arc_clockwise;
  bool has_absolute = false, has_step = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const SiemensWord* const word = words_.value(kCentreWords.at(i));
    if (word == nullptr) continue;
    (word->measure == SiemensMeasure::absolute ? has_absolute : has_step) = true;
    arc.centre_mm.at(i) = word->value * mm_per_unit();
  }
  arc.is_centre_absolute = has_absolute;
  if (has_absolute && has_step) to.open = "the centre of an arc is absolute in one word, and a step in another";
  if (words_.has_any({"I1", "J1", "K1"})) to.open = "G2 or G3 with a point between the ends";
  if (words_.value("CR") != nullptr) arc.radius_mm = length("CR");
  if (const SiemensWord* const turns = words_.value("TURN")) {
    constexpr double kMaxTurns = 999;
    const bool is_count = turns->value >= 0 && turns->value <= kMaxTurns && std::floor(turns->value) >= turns->value;
    arc.turns = is_count ? static_cast<int>(turns->value) + 1 : 0;
  }
  if (to.open.empty() && words_.value("AR") != nullptr) to.open = read_opening_angle(arc, to.place);
  const bool has_nan = to.place.xyz.hasNaN() || (arc.radius_mm && !is_known(*arc.radius_mm)) ||
                       std::ranges::any_of(arc.centre_mm, [](const auto& one) { return one && !is_known(*one); });
  if (to.open.empty() && has_nan) to.open = "a value of the arc is not known";
  if (!to.open.empty()) return motion_.go_unchecked(MoveKind::arc, to.place, to.open);
  const ArcReading read = read_program_arc(arc, from.xyz, to.place.xyz);
  if (!read.open.empty()) return motion_.go_unchecked(MoveKind::arc, to.place, read.open);
  motion_.go_round(to.place, read.arc);
}

// AR states the opening angle, with the centre or with the end. Completes the arc; returns why it cannot.
std::string SiemensRunner::read_opening_angle(ArcWords& arc, AxisPlace& end) {
  constexpr double kMin_deg = 1e-3, kMax_deg = 360 - 1e-3;
  const double opening = words_.value("AR")->value;
  if (!(opening > kMin_deg && opening < kMax_deg) || arc.radius_mm || arc.turns != 1)
    return "the opening angle of an arc is not understood";
  const auto u = static_cast<std::size_t>(arc.plane[0]), v = static_cast<std::size_t>(arc.plane[1]);
  const bool has_centre = words_.has_any({"I", "J", "K"});
  const bool has_end = words_.value(kAxisWords.at(u)) != nullptr || words_.value(kAxisWords.at(v)) != nullptr;
  if (has_centre == has_end) return "an opening angle needs either the centre of the arc or its end";
  const Vec3& start = motion_.place().xyz;
  const int iu = arc.plane[0], iv = arc.plane[1];
  if (has_end) {
    const double du = end.xyz[iu] - start[iu], dv = end.xyz[iv] - start[iv], chord = std::sqrt(du * du + dv * dv);
    const double radius = chord / (2 * std::sin(opening * kDegree_rad / 2));
    arc.radius_mm = opening > 180 ? -radius : radius;
    return {};
  }
  const auto centre_of = [&](std::size_t word, int axis) {
    const auto& stated = arc.centre_mm.at(word);
    return arc.is_centre_absolute ? stated.value_or(kUnknownValue) : start[axis] + stated.value_or(0);
  };
  const double cu = centre_of(u, iu), cv = centre_of(v, iv);
  const double turn = (arc.is_clockwise ? -opening : opening) * kDegree_rad;
  const double du = start[iu] - cu, dv = start[iv] - cv;
  end.xyz[iu] = cu + std::cos(turn) * du - std::sin(turn) * dv;
  end.xyz[iv] = cv + std::sin(turn) * du + std::cos(turn) * dv;
  return {};
}

void SiemensRunner::go_by_point(const Target& to) {
  std::string open;
  const Vec3& start = motion_.place().xyz;
  Vec3 middle = start;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto k = static_cast<int>(i);
    const SiemensWord* const word = words_.value(kPointWords.at(i));
    const bool is_level = std::abs(to.place.xyz[k] - start[k]) <= 0;
    if (word == nullptr && !is_level) open = "CIP states no point between the ends on an axis that moves";
    if (word == nullptr) continue;
    middle[k] = (is_incremental(*word) ? start[k] : 0) + word->value * mm_per_unit();
    if (is_incremental(*word) && word->measure == SiemensMeasure::modal)
      open = "CIP with G91: the start of its steps is not stated";
  }
  if (words_.has_any({"I", "J", "K", "CR", "AR", "TURN"})) open = "CIP with words of G2 and G3";
  if (!middle.allFinite() || to.place.xyz.hasNaN()) open = "a value of the arc is not known";
  const auto arc = open.empty() ? arc_through(start, middle, to.place.xyz) : std::nullopt;
  if (open.empty() && !arc) open = "the three points of CIP are on a line, or nearly";
  if (!arc) return motion_.go_unchecked(MoveKind::arc, to.place, open);
  motion_.go_round(to.place, *arc);
}

}  // namespace gouge
