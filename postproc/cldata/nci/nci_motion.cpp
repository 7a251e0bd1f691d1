#include "postproc/cldata/nci/nci_motion.h"

#include <algorithm>
#include <cmath>

#include "lib/base/number_text.h"
#include "lib/base/tolerance.h"
#include "postproc/cldata/language/text.h"

namespace gouge {

namespace {

constexpr std::size_t kFieldsOfLinear = 5, kFieldsOfArc = 8, kFieldsOfFiveAxis = 7;
constexpr std::size_t kFullCircleField = 9;
constexpr double kMinComp = 40;
constexpr double kRapidFeed = -2;
constexpr double kShortestVector = 1e-3;  // for a shorter vector the digits of the points give no direction
constexpr double kLargestFlags = 1e15;    // a larger number has no last digits

bool is_equal(double a, double b) { return std::abs(a - b) < Tolerance::kRounding; }

bool are_numbers(std::span<const Argument> fields, std::size_t count) {
  return fields.size() >= count && std::all_of(fields.begin(), fields.begin() + static_cast<std::ptrdiff_t>(count),
                                               [](const Argument& a) { return a.number.has_value(); });
}

Vec3 point(std::span<const Argument> fields, const std::array<std::size_t, 3>& at) {
  return {*fields[at[0]].number, *fields[at[1]].number, *fields[at[2]].number};
}

NciMotion failed(NciMotion motion, const char* problem) {
  motion.problem = problem;
  return motion;
}

NciMotion read_linear(std::span<const Argument> fields) {
  NciMotion motion;
  if (!fields.empty()) motion.compensation = fields[0].number;
  if (!are_numbers(fields, kFieldsOfLinear)) return failed(motion, NciProblems::kNumbers);
  motion.comp = 0;
  motion.tip = {1, 2, 3};
  motion.feed = 4;
  motion.flags = 5;
  return motion;
}

// Reads the plane. In some files compensation is before the plane, in others after it; the values show the order.
bool read_plane(std::span<const Argument> fields, NciMotion& motion) {
  const std::array<double, 2> value = {*fields[0].number, *fields[1].number};
  double plane = 0;
  motion.compensation.reset();
  if (value[0] >= kMinComp && value[1] >= kMinComp) return false;
  if (value[0] >= kMinComp || value[1] >= kMinComp) {
    motion.comp = value[0] >= kMinComp ? 0 : 1;
    motion.compensation = value[*motion.comp];
    plane = value[1 - *motion.comp];
  } else {
    if (!is_equal(value[0], 0) && !is_equal(value[1], 0)) return false;
    plane = is_equal(value[0], 0) ? value[1] : value[0];
  }
  for (const NciPlane known : {NciPlane::xy, NciPlane::yz, NciPlane::xz}) {
    if (!is_equal(plane, static_cast<double>(known))) continue;
    motion.plane = known;
    if (!motion.comp) motion.compensation = 0;
    return true;
  }
  return false;
}

NciMotion read_arc(int code, std::span<const Argument> fields) {
  NciMotion motion;
  motion.form = NciForm::arc;
  if (!are_numbers(fields, kFieldsOfArc)) return failed(motion, NciProblems::kNumbers);
  if (!read_plane(fields, motion)) return failed(motion, NciProblems::kPlane);
  motion.is_clockwise = code == NciCode::kClockwise;
  // The fields are the plane coordinates in the order of the plane's name, then the coordinate perpendicular to it.
  std::array<std::size_t, 3> center{};
  switch (motion.plane) {
    case NciPlane::xy:
      motion.tip = {2, 3, 6};
      center = {4, 5, 6};
      break;
    case NciPlane::yz:
      motion.tip = {6, 2, 3};
      center = {6, 4, 5};
      break;
    case NciPlane::xz:
      motion.tip = {2, 6, 3};
      center = {4, 6, 5};
      break;
  }
  motion.center = point(fields, center);
  motion.feed = 7;
  motion.flags = 8;
  if (fields.size() <= kFullCircleField) return motion;
  const std::optional<double> full = fields[kFullCircleField].number;
  if (!full || (!is_equal(*full, 0) && !is_equal(*full, 1))) return failed(motion, NciProblems::kFullCircle);
  motion.is_full_circle = is_equal(*full, 1);
  return motion;
}

// Returns whether the flags switch nothing: a digit of 2 or more for the hundreds or thousands switches compensation.
bool are_flags_plain(const std::optional<double>& flags) {
  if (!flags || !(*flags >= 0 && *flags <= kLargestFlags) || std::floor(*flags) < *flags) return false;
  const auto digits = static_cast<long long>(*flags);
  return digits / 100 % 10 < 2 && digits / 1000 % 10 < 2;
}

NciMotion read_five_axis(std::span<const Argument> fields) {
  NciMotion motion;
  motion.form = NciForm::five_axis;
  if (!are_numbers(fields, kFieldsOfFiveAxis)) return failed(motion, NciProblems::kNumbers);
  motion.tip = {0, 1, 2};
  motion.feed = 6;
  motion.flags = 8;
  if (fields.size() > motion.flags && !are_flags_plain(fields[motion.flags].number))
    return failed(motion, NciProblems::kFlags);
  motion.compensation = 0;
  const Vec3 vector = point(fields, kNciSecondPoint) - point(fields, motion.tip);
  motion.axis_length = vector.norm();
  if (!std::isfinite(motion.axis_length) || motion.axis_length < kShortestVector)
    return failed(motion, NciProblems::kVector);
  motion.axis = vector / motion.axis_length;
  return motion;
}

}  // namespace

NciMotion read_nci_motion(int code, std::span<const Argument> fields) {
  const bool is_arc = code == NciCode::kClockwise || code == NciCode::kCounterClockwise;
  NciMotion motion = is_arc                       ? read_arc(code, fields)
                     : code == NciCode::kFiveAxis ? read_five_axis(fields)
                                                  : read_linear(fields);
  if (motion.problem != nullptr) return motion;
  motion.is_rapid = code == NciCode::kRapid || is_equal(*fields[motion.feed].number, kRapidFeed);
  return motion;
}

namespace {

constexpr std::size_t kPairsLookedAt = 2000;  // hundreds of parameters may precede the first motion
constexpr std::size_t kMaxFields = 100;
constexpr std::size_t kMinNumbersOfMotion = 5;
constexpr int kLargestCode = 99999;

bool is_motion(const NciPair& pair) {
  if (!pair.code || *pair.code > 11) return false;
  std::vector<Argument> fields;
  split_nci_fields(pair.parameters, fields);
  return fields.size() >= kMinNumbersOfMotion &&
         std::all_of(fields.begin(), fields.end(), [](const Argument& a) { return a.number.has_value(); });
}

}  // namespace

bool NciLines::take_line(std::string_view& text) {
  if (at_ >= bytes_.size()) return false;
  const std::size_t end = bytes_.find('\n', at_);
  text = trim(bytes_.substr(at_, end - at_));
  at_ = end == std::string_view::npos ? bytes_.size() : end + 1;
  ++line_;
  return true;
}

bool NciLines::next(NciPair& pair) {
  std::string_view text;
  do {
    pair.first_byte = at_;
    pair.line = line_;
    if (!take_line(text)) return false;
  } while (text.empty());
  pair.code_text = text;
  pair.code.reset();
  const auto code = parse_integer(text);
  if (code && *code >= 0 && *code <= kLargestCode) pair.code = static_cast<int>(*code);
  pair.is_whole = take_line(pair.parameters);
  pair.last_byte = at_;
  return true;
}

void split_nci_fields(std::string_view parameters, std::vector<Argument>& fields) {
  fields.clear();
  while (!parameters.empty() && fields.size() < kMaxFields) {
    std::size_t end = 0;
    while (end < parameters.size() && !is_blank(parameters[end])) ++end;
    fields.push_back({parameters.substr(0, end), parse_number(parameters.substr(0, end))});
    parameters = trim(parameters.substr(end));
  }
}

bool is_nci(std::string_view bytes) {
  NciLines lines(bytes, 0, 1);
  NciPair pair;
  bool has_motion = false;
  for (std::size_t i = 0; i < kPairsLookedAt && lines.next(pair); ++i) {
    if (!pair.code || !pair.is_whole) return false;
    has_motion = has_motion || is_motion(pair);
  }
  return has_motion;
}

}  // namespace gouge
