#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "postproc/cldata/language/statement.h"

namespace gouge {

/// Maximum number of arguments. No CAM system writes a statement with so many, so a longer one is refused, not stored.
inline constexpr std::size_t kMaxArguments = 100000;

/// Splits the arguments of `statement` into `arguments`, whose memory is reused. They are separated by commas. CAM
/// systems also write blanks, line ends, brackets and further slashes between them. One trailing comma is allowed.
/// Stops at kMaxArguments.
void split_arguments(const Statement& statement, std::vector<Argument>& arguments);

/// Returns the first argument that is not a number, or nothing.
[[nodiscard]] const Argument* find_word_argument(std::span<const Argument> arguments);

/// Returns whether an argument is the word `word`, in upper or lower case.
[[nodiscard]] bool has_argument(std::span<const Argument> arguments, std::string_view word);

/// Returns the argument after the first word `word` if it is a number.
[[nodiscard]] std::optional<double> number_after(std::span<const Argument> arguments, std::string_view word);

struct NumberCount {
  std::size_t count = 0;
  std::size_t negative = 0;
};

/// Returns how many of the arguments are numbers, and how many of these are negative.
[[nodiscard]] NumberCount count_numbers(std::span<const Argument> arguments);

/// Returns half a unit in the last decimal of any of `arguments`: the maximum error of a number by rounding. It is 0
/// for numbers that a file does not write as text.
[[nodiscard]] double rounding_of(std::span<const Argument> arguments);

/// Returns the rounding of coordinates, which some writers pad with zeros after four decimals.
[[nodiscard]] double rounding_of_points(std::span<const Argument> arguments);

/// Returns whether only blanks separate two numbers of `statement`. They may be one number with blanks in it.
[[nodiscard]] bool has_blank_in_number(const Statement& statement);

/// Returns whether there is nothing between two commas, or digits, signs and points that do not form a number. The lost
/// text is unknown.
[[nodiscard]] bool has_damaged_argument(std::span<const Argument> arguments);

/// Returns whether a word occurs twice, in upper or lower case: then no reader can decide which one counts. Also
/// returns true for more than 64 words, which no understood statement has.
[[nodiscard]] bool has_repeated_word(std::span<const Argument> arguments);

}  // namespace gouge
