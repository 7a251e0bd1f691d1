#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// Conversion between numbers and text, independent of any locale. Text that is not completely a finite number is
// rejected: "1.2.3", "nan", "inf", "1e400", "0x10" and "".

namespace gouge {

/// Returns `text` without the white space at its ends.
[[nodiscard]] std::string_view trim_blanks(std::string_view text);

/// Returns the number in `text`. It accepts the forms that CAM systems write: an optional sign (also '+'), digits with
/// or without a leading or trailing point (".5", "25."), and an optional exponent (e, E). Surrounding blanks are not
/// accepted.
[[nodiscard]] std::optional<double> parse_number(std::string_view text);

/// Returns the whole number in `text`; nothing if there is none or it is out of range.
[[nodiscard]] std::optional<long long> parse_integer(std::string_view text);

/// Returns the shortest text that reads back as exactly `value`, but never "-0". Requires a finite value.
[[nodiscard]] std::string exact_text(double value);

/// Returns fixed notation with `decimals` digits after the point; never "-0.000".
[[nodiscard]] std::string fixed_text(double value, int decimals);

enum class Zeros { kept, dropped };

/// Returns a number for people: fixed_text, with its trailing zeros kept or dropped. From 1e15 on, more digits would
/// add no information, so the shortest form with an exponent is used ("1e+300").
[[nodiscard]] std::string display_text(double value, int decimals, Zeros zeros = Zeros::dropped);

/// Returns a count with its noun: "1 half", "7 halves".
[[nodiscard]] std::string count_text(std::size_t count, std::string_view one, std::string_view many);

/// Returns a count with its noun: "1 move", "7 moves".
[[nodiscard]] std::string count_text(std::size_t count, std::string_view noun);

/// Joins the words with commas, and the last two with `last`. Returns "a, b and c" for `last` = " and ".
[[nodiscard]] std::string listed(const std::vector<std::string>& words, std::string_view last = ", ");

/// Returns the number of bytes that a text such as "8GB", "1.5 MiB" or "4096" states; upper and lower case are equal.
/// kB, MB, GB and TB are powers of 1000; KiB, MiB, GiB and TiB are powers of 1024. A bare number or B is bytes. Returns
/// nothing for other text, for less than 1 byte, or for more than 2^62 bytes.
[[nodiscard]] std::optional<std::uint64_t> parse_byte_size(std::string_view text);

/// Returns a number of bytes for people, in powers of 1000: "8 GB", "12.35 MB", "999 bytes". Further digits are cut
/// off, not rounded up.
[[nodiscard]] std::string byte_size_text(std::uint64_t bytes);

}  // namespace gouge
