#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// A block of a program as its syntax gives it, before it has a meaning.

namespace gouge {

/// A value that the program does not establish: a variable of the control, or a number without its decimal point.
inline constexpr double kUnknownValue = std::numeric_limits<double>::quiet_NaN();
[[nodiscard]] inline bool is_known(double value) { return !std::isnan(value); }

/// Share of a value within which the digits of a control may differ from those of doubles.
inline constexpr double kOfControlDigits = 1e-6;

/// Returns whether a value is so near to a whole number, but not one, that a control may take it for the other side.
[[nodiscard]] inline bool is_nearly_whole(double x) {
  const double apart = std::abs(x - std::round(x));
  return apart > 0 && apart < kOfControlDigits * std::max(1.0, std::abs(x));
}

/// An address and its number: X12.5.
struct GcodeWord {
  char letter = 0;                              ///< a capital
  bool has_point = true;                        ///< the number has a decimal point, or is an expression
  double value = 0;                             ///< kUnknownValue: not established
  std::uint32_t first_byte = 0, last_byte = 0;  ///< range [first, last) of the line
};

/// A variable and its new value, which holds from the next block on.
struct GcodeAssignment {
  std::string variable;  ///< "101" or "<name>"
  double value = 0;
  bool is_rounded = false;  ///< other digits than those of doubles may give a value beside it
};

struct GcodeBlock {
  std::vector<GcodeWord> words;
  std::vector<GcodeAssignment> assignments;
  std::optional<long long> number;  ///< of N, at the start of the block
  bool is_skippable = false;        ///< begins with the mark for block delete
  std::string_view comment;         ///< text of the last comment; empty: none
  std::string_view flow;  ///< statement that changes the order of blocks: IF, WHILE, GOTO, O-words; empty: none
  std::string error;      ///< why the text is no block; empty: it is one

  void clear() {
    words.clear();
    assignments.clear();
    number.reset();
    is_skippable = false;
    comment = flow = {};
    error.clear();
  }
};

}  // namespace gouge
