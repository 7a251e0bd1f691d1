#include <array>

#include "lib/base/letters.h"
#include "postproc/gcode/lexing/expression.h"

namespace gouge {

namespace {

// Powers of ten that are exact doubles.
constexpr std::array<double, 16> kPowers = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                            1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};

}  // namespace

std::optional<double> read_plain_number(GcodeCursor& c, bool& has_point) {
  constexpr std::size_t kMaxDigits = 15;
  std::size_t at = c.at, digits = 0, decimals = 0;
  long long value = 0;
  bool is_behind = false;
  for (; at < c.text.size(); ++at) {
    const char one = c.text[at];
    if (is_digit(one)) {
      value = value * 10 + (one - '0');
      ++digits;
      decimals += is_behind ? 1U : 0U;
      if (digits > kMaxDigits) return std::nullopt;
    } else if (one == '.' && !is_behind) {
      is_behind = true;
    } else {
      break;
    }
  }
  if (digits == 0 || (at < c.text.size() && c.text[at] == '.')) return std::nullopt;
  c.at = at;
  has_point = is_behind;
  return static_cast<double>(value) / kPowers[decimals];
}

}  // namespace gouge
