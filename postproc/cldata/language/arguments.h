#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "postproc/cldata/language/statement.h"

namespace gouge {

/// No CAM system writes a statement of so many arguments; one that has them is refused rather than held.
inline constexpr std::size_t kMaxArguments = 100000;

/// The arguments of `statement`, into `arguments` (whose memory is used again). Commas separate them; so do
/// blanks, line ends, brackets and further slashes, as CAM systems write them. One trailing comma is allowed.
/// Stops at kMaxArguments.
void split_arguments(const Statement& statement, std::vector<Argument>& arguments);

/// Returns the first argument that is not a number, or nothing.
[[nodiscard]] const Argument* find_word_argument(std::span<const Argument> arguments);

/// Returns true where an argument is the word `word`, in any case.
[[nodiscard]] bool has_argument(std::span<const Argument> arguments, std::string_view word);

/// Returns the argument behind the first word `word`, where it is a number.
[[nodiscard]] std::optional<double> number_after(std::span<const Argument> arguments, std::string_view word);

struct NumberCount {
  std::size_t count = 0;
  std::size_t negative = 0;
};

/// Returns how many of the arguments are numbers, and how many of these are below 0.
[[nodiscard]] NumberCount count_numbers(std::span<const Argument> arguments);

/// Returns half a unit in the last place that any of `arguments` is written to: how far rounding puts a number off.
/// Numbers that a file does not write as text have none: 0.
[[nodiscard]] double rounding_of(std::span<const Argument> arguments);

/// Returns the same of coordinates, which some writers pad with zeros behind four decimals.
[[nodiscard]] double rounding_of_points(std::span<const Argument> arguments);

/// Returns true where nothing but blanks separates two numbers of `statement`: they may be one number with blanks
/// within.
[[nodiscard]] bool has_blank_in_number(const Statement& statement);

/// Returns whether nothing stands between two commas, or digits, signs and points do not form a number. The lost text
/// is unknown.
[[nodiscard]] bool has_damaged_argument(std::span<const Argument> arguments);

/// Returns true where a word stands twice, in any case: no reader can show which of both counts. Also true of more than
/// 64 words, as no statement that is understood has them.
[[nodiscard]] bool has_repeated_word(std::span<const Argument> arguments);

}  // namespace gouge
