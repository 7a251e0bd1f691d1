#include "lib/base/leading_number.h"

#include <array>
#include <cstdint>

#include "lib/base/letters.h"

namespace gouge {

// The digits as one integer and the power of ten are both exact doubles. So their quotient is the nearest double (Clinger,
// How to read floating point numbers accurately, 1990). That holds for nearly all numbers in a toolpath.
LeadingNumber leading_number(std::string_view text) {
  constexpr std::size_t kMaxDigits = 19;  // an integer of so many digits does not overflow
  constexpr std::uint64_t kLargestExact = std::uint64_t{1} << 53U;
  constexpr std::array<double, kMaxDigits + 1> kPowersOfTen = {
      1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19};
  const bool is_negative = !text.empty() && text.front() == '-';
  const char* at = text.data() + (is_negative ? 1 : 0);
  const char* const end = text.data() + text.size();
  std::uint64_t digits = 0;
  const auto take_digits = [&] {
    const char* const first = at;
    for (; at != end && is_digit(*at); ++at) digits = digits * 10 + static_cast<std::uint64_t>(*at - '0');
    return static_cast<std::size_t>(at - first);
  };
  std::size_t count = take_digits(), decimals = 0;
  if (at != end && *at == '.') {
    ++at;
    decimals = take_digits();
    count += decimals;
  }
  if (count == 0 || count > kMaxDigits || digits > kLargestExact) return {};
  const double value = static_cast<double>(digits) / kPowersOfTen[decimals];
  return {is_negative ? -value : value, static_cast<std::size_t>(at - text.data())};
}

}  // namespace gouge
