#include "postproc/cldata/parsing/spindle_statement.h"

#include <algorithm>
#include <initializer_list>
#include <string_view>

#include "postproc/cldata/language/text.h"

namespace gouge {

std::optional<float> read_spindle_speed(std::span<const Argument> arguments) {
  if (has_argument(arguments, "OFF") || has_argument(arguments, "SFM") || has_argument(arguments, "SMM")) return 0.0F;
  const auto is_rpm = [](const Argument& a) { return !a.number && equals_ignoring_case(a.text, "RPM"); };
  const auto is_number = [](const Argument& a) { return a.number.has_value(); };
  const auto rpm = std::ranges::find_if(arguments, is_rpm);
  auto speed = std::ranges::find_if(arguments, is_number);
  if (rpm != arguments.end() && rpm != arguments.begin() && is_number(*(rpm - 1))) speed = rpm - 1;
  if (rpm != arguments.end() && rpm + 1 != arguments.end() && is_number(*(rpm + 1))) speed = rpm + 1;
  if (speed == arguments.end()) return std::nullopt;
  return static_cast<float>(std::max(0.0, *speed->number));
}

std::optional<bool> stops_spindle(std::span<const Argument> arguments) {
  const auto has_any = [&](std::initializer_list<std::string_view> words) {
    return std::ranges::any_of(words, [&](std::string_view word) { return has_argument(arguments, word); });
  };
  if (has_any({"OFF", "ORIENT", "LOCK", "NEUTRL"})) return true;
  const bool is_along_surface = has_any({"SFM", "SMM"});
  const std::optional<float> speed = read_spindle_speed(arguments);
  if (!is_along_surface && speed && !(*speed > 0)) return true;
  const bool has_speed_first = !arguments.empty() && arguments.front().number.has_value();
  if (has_speed_first || is_along_surface || has_any({"ON", "CLW", "CCLW", "RPM"})) return false;
  return std::nullopt;
}

}  // namespace gouge
