#include "postproc/cldata/parsing/arc_statement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "lib/base/tolerance.h"
#include "postproc/cldata/language/text.h"

namespace gouge {
namespace {

constexpr double kPi = std::numbers::pi;
// Maximum distance of points from each other's circle, relative to the error `rounding` of their numbers. Coordinates
// with 4 decimals of an inch give 0.008 mm.
constexpr double kRadiusError = 6;
// error of positions that were rounded in inches, with any number of decimals now
constexpr double kEndsError_mm = 0.008;
constexpr double kNearFull_mm = 0.02;    // an arc that ends so near before its start may be meant as a full circle
constexpr double kTinyChord_mm = 2e-3;   // rounding could turn an arc with this chord into a full circle
constexpr double kTurnsChord_mm = 0.01;  // the same for whole turns, which TIMES states, in inches with 4 decimals
constexpr double kAngleError_rad = 0.01;
constexpr double kMinTangency = 0.02;  // cosine between tangent and radius that can result from rounding
constexpr double kMaxTurns = 1000;

// Returns whether a statement has a known form: centre and vector, possibly the radius, possibly the numbers that NX
// and CAMplete write after it. Any other count means that a comma is lost or a number is repeated, so the numbers after
// it would be misread. Readers of records make their own lists.
bool has_known_form(ArcForm form, std::span<const Argument> arguments) {
  if (form == ArcForm::nci) return true;
  constexpr std::array<std::string_view, 7> kWords = {"CENTER", "AXIS",      "RADIUS",          "TIMES",
                                                      "ANGLE",  "CLOCKWISE", "COUNTERCLOCKWISE"};
  std::size_t numbers = 0;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string_view text = arguments[i].text;
    if (arguments[i].number) {
      ++numbers;
    } else if (!is_one_of(text, kWords)) {
      return false;
    } else if (equals_ignoring_case(text, "TIMES") || equals_ignoring_case(text, "ANGLE")) {
      if (++i >= arguments.size() || !arguments[i].number) return false;
    }
  }
  if (form == ArcForm::ncl) return true;
  const bool has_angle = form == ArcForm::with_sweep && numbers == 8;
  // The first of the four numbers that NX writes after the radius is a tolerance; an angle there is not read.
  constexpr std::size_t kTolerance = 7;
  constexpr double kLargestTolerance = 1;
  const bool has_tolerances = numbers == 11 && (form == ArcForm::with_sweep || !arguments[kTolerance].number ||
                                                *arguments[kTolerance].number <= kLargestTolerance);
  return numbers == 6 || numbers == 7 || has_tolerances || has_angle;
}

std::optional<Vec3> vector_after(std::span<const Argument> arguments, std::string_view word) {
  for (std::size_t i = 0; i + 3 < arguments.size(); ++i) {
    if (!equals_ignoring_case(arguments[i].text, word)) continue;
    if (!arguments[i + 1].number || !arguments[i + 2].number || !arguments[i + 3].number) return std::nullopt;
    return Vec3(*arguments[i + 1].number, *arguments[i + 2].number, *arguments[i + 3].number);
  }
  return std::nullopt;
}

// Returns the numbers before the first word.
std::vector<double> leading_numbers(std::span<const Argument> arguments) {
  std::vector<double> numbers;
  for (const Argument& argument : arguments) {
    if (!argument.number) break;
    numbers.push_back(*argument.number);
  }
  return numbers;
}

// Reads CENTER,x,y,z,AXIS,i,j,k,RADIUS,r of DMG Mori, or x,y,z,i,j,k[,r] of all other writers.
bool read_circle(std::span<const Argument> arguments, ArcStatement& statement) {
  if (const std::optional<Vec3> center = vector_after(arguments, "CENTER")) {
    const std::optional<Vec3> axis = vector_after(arguments, "AXIS");
    if (!axis) return false;
    statement.center = *center;
    statement.axis = *axis;
    statement.radius_mm = number_after(arguments, "RADIUS");
    return true;
  }
  const std::vector<double> n = leading_numbers(arguments);
  if (n.size() < 6) return false;
  statement.center = Vec3(n[0], n[1], n[2]);
  statement.axis = Vec3(n[3], n[4], n[5]);
  if (n.size() > 6) statement.radius_mm = n[6];
  return true;
}

// Reads the sense in CAMWorks CLT and Mastercam NCI. The vector is a positive axis of the part, and a word states the
// sense. Returns false if both words occur.
bool read_sense_word(std::span<const Argument> arguments, ArcStatement& statement) {
  const bool is_right = has_argument(arguments, "COUNTERCLOCKWISE"), is_left = has_argument(arguments, "CLOCKWISE");
  if (is_right) statement.sense = ArcSense::right_handed;
  if (is_left) statement.sense = ArcSense::left_handed;
  return !(is_right && is_left);
}

// Returns the rounding of the centre, or of the radius if the centre has integers. The vector has its own number of
// decimals. Records have numbers with an unknown number of decimals.
double rounding_of_circle(const Dialect& dialect, std::span<const Argument> arguments) {
  if (dialect.is_binary) return kEndsError_mm / kRadiusError;
  constexpr std::size_t kCenter = 3;
  const std::size_t first = arguments.front().number ? 0 : 1;  // after the word CENTER
  const double center = rounding_of_points(arguments.subspan(first, std::min(kCenter, arguments.size() - first)));
  const bool has_radius = arguments.size() > 2 * kCenter && arguments[2 * kCenter].number;
  return center > 0 || !has_radius ? center : rounding_of_points(arguments.subspan(2 * kCenter, 1));
}

double positive(double angle) { return angle <= 0 ? angle + 2 * kPi : angle; }

// Returns whether a statement is that of PTC: x,y,z,r, without a vector to show the sense.
bool is_flat_circle(std::span<const Argument> arguments) {
  constexpr std::size_t kNumbers = 4;
  return arguments.size() == kNumbers && find_word_argument(arguments) == nullptr;
}

ArcStatement flat_arc(const Dialect& dialect, std::span<const Argument> arguments, double mm_per_unit) {
  ArcStatement statement;
  statement.center = Vec3(*arguments[0].number, *arguments[1].number, *arguments[2].number) * mm_per_unit;
  statement.radius_mm = *arguments[3].number * mm_per_unit;
  statement.rounding_mm = rounding_of_circle(dialect, arguments) * mm_per_unit;
  return statement;
}

// Returns whether the radii agree. Those of start and end may differ by the rounding of coordinates. The stated radius
// may differ from both by its rounding, or by twice their difference.
bool fits_radius(const ArcStatement& statement, double start_mm, double end_mm) {
  const double rounding_mm = std::clamp(kRadiusError * statement.rounding_mm, Tolerance::kFilePoint_mm, kEndsError_mm);
  const double ends_mm = std::abs(start_mm - end_mm);
  const double stated = statement.radius_mm.value_or(start_mm);
  const double stated_mm = std::max(std::abs(start_mm - stated), std::abs(end_mm - stated));
  return ends_mm <= kEndsError_mm && stated_mm <= std::max(rounding_mm, 2 * ends_mm);
}

}  // namespace

ArcStatement unreadable_arc(std::string_view problem) {
  ArcStatement arc;
  arc.problem = problem;
  return arc;
}

ArcStatement read_arc(const Dialect& dialect, std::span<const Argument> arguments, double mm_per_unit) {
  ArcStatement statement;
  const bool is_flat = dialect.has_flat_circles && is_flat_circle(arguments);
  if (has_repeated_word(arguments) || has_damaged_argument(arguments) ||
      !(is_flat || has_known_form(dialect.arc_form, arguments)))
    return unreadable_arc(ArcProblems::kForm);
  if (is_flat) return flat_arc(dialect, arguments, mm_per_unit);
  if (!read_circle(arguments, statement)) return unreadable_arc(ArcProblems::kForm);
  if (dialect.arc_form == ArcForm::nci && has_argument(arguments, "ZXPLAN"))
    return unreadable_arc(ArcProblems::kXzPlane);
  const double length = statement.axis.norm();
  if (!(std::abs(length - 1) <= Tolerance::kUnitVectorError)) return unreadable_arc(ArcProblems::kForm);
  statement.axis /= length;
  statement.center *= mm_per_unit;
  if (statement.radius_mm) *statement.radius_mm *= mm_per_unit;
  statement.rounding_mm = rounding_of_circle(dialect, arguments) * mm_per_unit;
  statement.sense = dialect.arc_sense;
  const bool has_word = has_argument(arguments, "CLOCKWISE") || has_argument(arguments, "COUNTERCLOCKWISE");
  const bool has_sense =
      statement.sense != ArcSense::unknown || (dialect.arc_form == ArcForm::ncl && !dialect.is_binary);
  if (has_word && has_sense) return unreadable_arc(ArcProblems::kBothSenses);
  if (!read_sense_word(arguments, statement)) return unreadable_arc(ArcProblems::kBothSenses);

  std::optional<double> sweep_deg = number_after(arguments, "ANGLE");
  if (dialect.arc_form == ArcForm::with_sweep && arguments.size() > 7 && arguments[7].number)
    sweep_deg = arguments[7].number;
  if (sweep_deg && *sweep_deg < 0) return unreadable_arc(ArcProblems::kForm);
  if (sweep_deg && *sweep_deg > 0) statement.sweep_rad = *sweep_deg * kPi / 180;
  if (has_argument(arguments, "TIMES")) {
    const double times = number_after(arguments, "TIMES").value_or(0);
    if (!(times >= 1 && times <= kMaxTurns) || std::floor(times) < times) return unreadable_arc(ArcProblems::kForm);
    statement.turns = static_cast<int>(times);
  }
  return statement;
}

bool is_tlon_of_numbers(std::span<const Argument> arguments) {
  return vector_after(arguments, "CIRCLE").has_value() && vector_after(arguments, "LINE").has_value();
}

// Reads GOFWD,CIRCLE,x,y,z,r,ON[,2,INTOF],LINE,x,y,z,x,y,z and no other form: PAST, TO and TANTO end elsewhere.
std::optional<TlonStatement> read_tlon(std::span<const Argument> arguments, double mm_per_unit) {
  const auto is_word = [&](std::size_t i, std::string_view word) {
    return equals_ignoring_case(arguments[i].text, word);
  };
  const auto are_numbers = [&](std::size_t first, std::size_t count) {
    const auto numbers = arguments.subspan(first, count);
    return std::all_of(numbers.begin(), numbers.end(), [](const Argument& a) { return a.number.has_value(); });
  };
  constexpr std::size_t kShort = 14, kLong = 16;
  const std::size_t size = arguments.size();
  if (size != kShort && size != kLong) return std::nullopt;
  if (!is_word(0, "GOFWD") || !is_word(1, "CIRCLE") || !are_numbers(2, 4) || !is_word(6, "ON")) return std::nullopt;
  const bool is_second = size == kLong;
  if (is_second && (arguments[7].number != 2 || !is_word(8, "INTOF"))) return std::nullopt;
  if (!is_word(size - 7, "LINE") || !are_numbers(size - 6, 6)) return std::nullopt;
  const auto vector_at = [&](std::size_t i) {
    return Vec3(Vec3(*arguments[i].number, *arguments[i + 1].number, *arguments[i + 2].number) * mm_per_unit);
  };
  TlonStatement tlon;
  tlon.center = vector_at(2);
  tlon.radius_mm = *arguments[5].number * mm_per_unit;
  tlon.end = vector_at(size - 3);
  tlon.is_beyond_half = is_second;
  tlon.rounding_mm = rounding_of_points(arguments) * mm_per_unit;
  return tlon;
}

ArcStatement arc_of_tlon(const TlonStatement& tlon, const Vec3& start, const std::optional<Vec3>& tangent) {
  const Vec3 radial = start - tlon.center;
  if (!(radial.norm() > Tolerance::kSamePoint_mm)) return unreadable_arc(ArcProblems::kPoint);
  if (!tangent || !(tangent->norm() > 0)) return unreadable_arc(ArcProblems::kTangent);
  const Vec3 direction = tangent->normalized();
  if (std::abs(direction.dot(radial.normalized())) > kMinTangency) return unreadable_arc(ArcProblems::kTangent);
  ArcStatement statement;
  statement.center = tlon.center;
  statement.axis = radial.cross(direction).normalized();
  statement.radius_mm = tlon.radius_mm;
  statement.rounding_mm = tlon.rounding_mm;
  statement.sense = ArcSense::right_handed;
  const ArcFit fit = fit_arc(statement, start, tlon.end);
  if (!fit.problem.empty()) return statement;
  // Within rounding of half a turn both words are right.
  const bool is_beyond_half = fit.arc.sweep_rad > kPi;
  if (is_beyond_half != tlon.is_beyond_half && std::abs(fit.arc.sweep_rad - kPi) > kAngleError_rad &&
      fit.arc.sweep_rad < 2 * kPi - kAngleError_rad) {
    return unreadable_arc(ArcProblems::kHalf);
  }
  return statement;
}

ArcFit fit_arc(const ArcStatement& statement, const Vec3& start, const Vec3& end) {
  ArcFit fit;
  fit.problem = statement.problem;
  if (!fit.problem.empty()) return fit;
  fit.arc.center = statement.center;
  fit.arc.axis = statement.axis;
  const Vec3 from = start - statement.center, to = end - statement.center;
  const Vec3 a = from - from.dot(statement.axis) * statement.axis;
  const Vec3 b = to - to.dot(statement.axis) * statement.axis;
  const double r0 = a.norm(), r1 = b.norm();
  const double stated = statement.radius_mm.value_or(r0);
  fit.radius_error_mm = std::max({std::abs(r0 - r1), std::abs(r0 - stated), std::abs(r1 - stated)});
  if (!fits_radius(statement, r0, r1)) fit.problem = ArcProblems::kRadius;
  if (!(std::min(r0, r1) > Tolerance::kSamePoint_mm)) fit.problem = ArcProblems::kPoint;
  if (statement.sense == ArcSense::unknown) fit.problem = ArcProblems::kSense;
  if (!fit.problem.empty()) return fit;

  const double sign = statement.sense == ArcSense::right_handed ? 1 : -1;
  const double chord = (b - a).norm();
  const bool is_full = chord <= Tolerance::kSamePoint_mm;
  double sweep = 2 * kPi;
  if (!is_full) sweep = positive(sign * std::atan2(statement.axis.dot(a.cross(b)), a.dot(b)));
  const double tiny = statement.turns > 1 ? kTurnsChord_mm : kTinyChord_mm;
  const double nearest = sweep > kPi && statement.turns == 1 ? kNearFull_mm : tiny;
  const bool is_tiny = !is_full && chord <= std::min(nearest, 0.1 * r0);
  if (statement.turns > 1) {
    if (!is_full && !is_tiny) fit.problem = ArcProblems::kTimes;
    if ((is_full || is_tiny) && sweep < kPi) sweep += 2 * kPi;
    sweep += 2 * kPi * (statement.turns - 1);
  } else if (statement.sweep_rad) {
    sweep += 2 * kPi * std::round((*statement.sweep_rad - sweep) / (2 * kPi));
    const double allowed = kAngleError_rad + 2 * kNearFull_mm / r0;
    if (std::abs(sweep - *statement.sweep_rad) > allowed || *statement.sweep_rad > 2 * kPi * kMaxTurns) {
      fit.problem = ArcProblems::kAngle;
    }
  } else if (is_tiny) {
    fit.problem = ArcProblems::kTiny;
  }
  fit.arc.sweep_rad = sign * sweep;
  return fit;
}

bool fits_both_ways(ArcStatement statement, const Vec3& start, const Vec3& end) {
  statement.sense = ArcSense::right_handed;
  const bool fits_right = fit_arc(statement, start, end).problem.empty();
  statement.sense = ArcSense::left_handed;
  return fits_right && fit_arc(statement, start, end).problem.empty();
}

Vec3 arc_tangent(const ArcStatement& statement, const Vec3& tip) {
  const Vec3 tangent = statement.axis.cross(tip - statement.center);
  const double length = tangent.norm();
  return length > 0 ? Vec3(tangent / length) : Vec3(Vec3::Zero());
}

}  // namespace gouge
