#include "cli/values/parse_lengths.h"

#include <cmath>
#include <string_view>

#include "lib/base/number_text.h"
#include "lib/base/tolerance.h"
#include "lib/base/units.h"
#include "lib/check/reach.h"

namespace gouge {
namespace {

// Returns the length if it is within the reach of a check; a longer one is a mistake.
std::optional<double> within_reach(double length_mm) {
  return std::abs(length_mm) <= kFarthest_mm ? std::optional(length_mm) : std::nullopt;
}

Eigen::Matrix3d turn(double degrees, const Vec3& axis) {
  // fmod is exact. Sine and cosine of a huge angle are unreliable, and rounding them below would give no rotation.
  degrees = std::fmod(degrees, 360);
  const double quarters = degrees / 90;
  const double whole = std::round(quarters);
  // Quarter turns are exact, so that a part on its side keeps its coordinates.
  if (std::abs(quarters - whole) < Tolerance::kFewRoundings) {
    const Eigen::Matrix3d exact = Eigen::AngleAxisd(whole * M_PI / 2, axis).toRotationMatrix();
    return exact.unaryExpr([](double x) { return std::round(x); });
  }
  return Eigen::AngleAxisd(degrees * M_PI / 180, axis).toRotationMatrix();
}

}  // namespace

std::vector<std::string> split_text(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= text.size(); ++i) {
    if (i < text.size() && text[i] != separator) continue;
    parts.push_back(text.substr(begin, i - begin));
    begin = i + 1;
  }
  return parts;
}

std::optional<double> parse_length_mm(const std::string& text) {
  // A longer suffix comes before its end.
  constexpr struct {
    std::string_view suffix;
    LengthUnit unit;
  } kSuffixes[] = {{"mm", LengthUnit::mm},        {"cm", LengthUnit::cm},        {"um", LengthUnit::um},
                   {"\xc2\xb5m", LengthUnit::um}, {"\xce\xbcm", LengthUnit::um}, {"inch", LengthUnit::inch},
                   {"in", LengthUnit::inch}};
  std::string_view number = trim_blanks(text);
  LengthUnit unit = LengthUnit::mm;
  for (const auto& [suffix, of_suffix] : kSuffixes) {
    if (!number.ends_with(suffix)) continue;
    number = trim_blanks(number.substr(0, number.size() - suffix.size()));
    unit = of_suffix;
    break;
  }
  const auto value = parse_number(number);
  return value ? within_reach(*value * mm_per(unit)) : std::nullopt;
}

std::string decimal_comma_hint(const std::string& text) {
  std::string pointed = text;
  const std::size_t comma = pointed.find(',');
  if (comma == std::string::npos || pointed.find_first_of(",=", comma + 1) != std::string::npos) return {};
  pointed[comma] = '.';
  return parse_length_mm(pointed) ? "; write a decimal point in place of the comma: " + pointed : "";
}

std::optional<LengthRange> parse_length_range(const std::string& text) {
  const std::size_t dots = text.find("..");
  const std::optional<double> low = parse_length_mm(text.substr(0, dots));
  const std::optional<double> high = dots == std::string::npos ? low : parse_length_mm(text.substr(dots + 2));
  if (!low || !high || !(*low <= *high)) return std::nullopt;
  return LengthRange{0.5 * (*low + *high), 0.5 * (*high - *low)};
}

std::optional<std::vector<double>> parse_numbers(const std::string& text, std::size_t count) {
  std::vector<double> numbers;
  for (const std::string& part : split_text(text, ',')) {
    const auto number = parse_number(part);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers.size() == count ? std::optional(numbers) : std::nullopt;
}

std::optional<RigidTransform> parse_place(const std::string& text) {
  const std::vector<std::string> parts = split_text(text, ',');
  if (parts.size() != 3 && parts.size() != 6) return std::nullopt;
  RigidTransform place;
  for (int k = 0; k < 3; ++k) {
    const auto length = parse_length_mm(parts[static_cast<std::size_t>(k)]);
    if (!length) return std::nullopt;
    place.shift[k] = *length;
  }
  for (int k = 0; k < 3 && parts.size() == 6; ++k) {
    const auto degrees = parse_number(parts[static_cast<std::size_t>(k) + 3]);
    if (!degrees) return std::nullopt;
    place.rotation = turn(*degrees, Vec3::Unit(k)) * place.rotation;
  }
  return place;
}

}  // namespace gouge
