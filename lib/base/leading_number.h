#pragma once

#include <cstddef>
#include <string_view>

namespace gouge {

/// A number at the beginning of a text.
struct LeadingNumber {
  double value = 0;
  std::size_t length = 0;  ///< its number of characters; 0: there is none
};

/// Returns the longest number at the beginning of `text` that consists of an optional minus sign, digits, and at most one
/// point. Its value is that of parse_number (number_text.h). Returns none if there is no such number, and for a number
/// of too many digits, which takes longer to read.
[[nodiscard]] LeadingNumber leading_number(std::string_view text);

}  // namespace gouge
