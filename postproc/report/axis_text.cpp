#include "postproc/report/axis_text.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lib/base/number_text.h"

namespace gouge {
namespace {

constexpr double kMinPlain = 0.001;
constexpr double kDegreesOfText = 180 / std::numbers::pi;

// Returns a value with three digits. They are those of the rounded value: 9.996 is 10.0.
std::string three_digits(double value) {
  if (!(value > 0)) return "0";
  int power = 0;
  double first = value;
  for (; first >= 9.995 && power < 300; first /= 10) ++power;
  for (; first < 0.9995 && power > -300; first *= 10) --power;
  if (value >= kMinPlain) return display_text(value, std::clamp(2 - power, 0, 15));
  const std::string exponent = std::to_string(-power);
  return display_text(first, 2) + "e-" + (exponent.size() < 2 ? "0" : "") + exponent;
}

std::string degrees(double angle, DegreeSign sign) {
  return three_digits(angle) + (sign == DegreeSign::sign ? "°" : " deg");
}

std::string turn_line(const ReportModel& model, const AxisFacts& axes) {
  const LengthUnit unit = model.toolpath->unit;
  const auto rate = [&](const AxisQuality& q) {
    return turn_rate_text(q.turn_rad_per_mm.value, unit, DegreeSign::word);
  };
  const std::string line = line_of_move(*model.toolpath, axes.after.turn_rad_per_mm.move);
  const std::size_t spots = axes.after.turns_on_the_spot, spots_before = axes.before.turns_on_the_spot;
  const std::string on_the_spot =
      spots + spots_before == 0
          ? std::string()
          : ", " + count_text(spots, "turn") + " on the spot (before " + std::to_string(spots_before) + ")";
  return "axis turns: up to " + rate(axes.after) + (line.empty() ? "" : " at " + line) + " (before " +
         rate(axes.before) + "), " + angle_text(axes.after.turn_rad.value, DegreeSign::word) + " in a move (before " +
         angle_text(axes.before.turn_rad.value, DegreeSign::word) + "), J " + bending_text(axes.after.bending, unit) +
         " rad^2/" + unit_name(unit) + "^3 (before " + bending_text(axes.before.bending, unit) + ")" + on_the_spot +
         "\n";
}

std::string tilt_line(const ReportModel& model, const AxisTilts& tilts) {
  if (tilts.positions == 0) return {};
  return "tilted: " + count_text(tilts.positions, "position") + " by up to " +
         angle_text(tilts.tilt_rad.value, DegreeSign::word) + " at " +
         line_of_move(*model.toolpath, tilts.tilt_rad.move) + "\n";
}

std::string time_line(const AxisFacts& axes) {
  const auto both = [](double after, double before) {
    return feed_time_text(after) + " (before " + feed_time_text(before) + ")";
  };
  std::string text = "feed time: " + both(axes.after.feed_seconds, axes.before.feed_seconds);
  if (axes.max_rotary_deg_per_min) {
    text += "; turning by at most " + display_text(*axes.max_rotary_deg_per_min, 3) + " deg/min " +
            both(axes.after.limited_feed_seconds.value_or(0), axes.before.limited_feed_seconds.value_or(0));
  }
  if (axes.after.moves_without_feed > 0)
    text += "; not counted: " + count_text(axes.after.moves_without_feed, "move") + " without a feed per minute";
  return text + "\n";
}

}  // namespace

std::string angle_text(double angle_rad, DegreeSign sign) { return degrees(angle_rad * kDegreesOfText, sign); }

std::string turn_rate_text(double turn_rad_per_mm, LengthUnit unit, DegreeSign sign) {
  return degrees(turn_rad_per_mm * kDegreesOfText * mm_per(unit), sign) + "/" + unit_name(unit);
}

std::string bending_text(double bending, LengthUnit unit) { return three_digits(bending * std::pow(mm_per(unit), 3)); }

std::string feed_time_text(double seconds) {
  if (!std::isfinite(seconds)) return "without end";
  constexpr double kMinute = 60, kHour = 3600;
  if (seconds < kMinute) return three_digits(seconds) + " s";
  const double small = seconds < kHour ? 1 : kMinute, large = small * 60;
  const double rounded = std::round(seconds / small) * small;
  const double left = std::round((rounded - std::floor(rounded / large) * large) / small);
  return display_text(std::floor(rounded / large), 0) + (seconds < kHour ? " min " : " h ") + display_text(left, 0) +
         (seconds < kHour ? " s" : " min");
}

std::string line_of_move(const Toolpath& path, std::size_t move) {
  return move < path.moves.size() ? "line " + std::to_string(path.moves[move].line) : std::string();
}

std::string axis_lines(const ReportModel& model) {
  const AxisFacts& axes = *model.correction.axes;
  if (!axes.is_of_interest()) return {};
  return (axes.before.has_turns() || axes.after.has_turns() ? turn_line(model, axes) : std::string()) +
         tilt_line(model, axes.tilts) + time_line(axes);
}

}  // namespace gouge
