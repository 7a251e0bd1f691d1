#include "postproc/cldata/parsing/spindle_statement.h"

#include <algorithm>

#include "postproc/cldata/language/text.h"

namespace gouge {

std::optional<float> read_spindle_speed(std::span<const Argument> arguments) {
  const auto is_word = [&](std::size_t at, std::string_view word) {
    return at < arguments.size() && !arguments[at].number && equals_ignoring_case(arguments[at].text, word);
  };
  if (has_argument(arguments, "OFF") || has_argument(arguments, "SFM") || has_argument(arguments, "SMM")) return 0.0F;
  std::optional<std::size_t> speed;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (!arguments[i].number) continue;
    const bool is_beside = is_word(i + 1, "RPM") || (i > 0 && is_word(i - 1, "RPM"));
    if (!speed || is_beside) speed = i;
    if (is_beside) break;
  }
  if (!speed) return std::nullopt;
  return static_cast<float>(std::max(0.0, *arguments[*speed].number));
}

}  // namespace gouge
