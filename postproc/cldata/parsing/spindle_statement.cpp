#include "postproc/cldata/parsing/spindle_statement.h"

#include <algorithm>

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

bool stops_spindle(std::span<const Argument> arguments) {
  return has_argument(arguments, "OFF") || has_argument(arguments, "ORIENT") || has_argument(arguments, "LOCK");
}

}  // namespace gouge
