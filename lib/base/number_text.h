#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// Numbers as text, independent of any locale. Text that is not wholly a finite number is not a number:
// "1.2.3", "nan", "inf", "1e400", "0x10" and "" are refused.

namespace gouge {

/// Returns `text` without the white space at its ends.
[[nodiscard]] std::string_view trim_blanks(std::string_view text);

/// Accepts what CAM systems write: an optional sign (also '+'), digits with or without a leading or
/// trailing point (".5", "25."), an optional exponent (e, E). Surrounding blanks are not accepted.
[[nodiscard]] std::optional<double> parse_number(std::string_view text);

/// Returns the whole number in `text`, or nothing (also when it does not fit).
[[nodiscard]] std::optional<long long> parse_integer(std::string_view text);

/// Returns the shortest text that reads back as exactly `value`. Requires a finite value. Never "-0".
[[nodiscard]] std::string exact_text(double value);

/// Returns fixed notation with `decimals` digits after the point; never "-0.000".
[[nodiscard]] std::string fixed_text(double value, int decimals);

enum class Zeros { kept, dropped };

/// Returns a number for people: fixed_text, with the zeros at its end kept or dropped. From 1e15 on more digits would
/// state nothing, so the shortest form with an exponent is used ("1e+300").
[[nodiscard]] std::string display_text(double value, int decimals, Zeros zeros = Zeros::dropped);

/// Returns "1 half", "7 halves".
[[nodiscard]] std::string count_text(std::size_t count, std::string_view one, std::string_view many);

/// Returns "1 move", "7 moves".
[[nodiscard]] std::string count_text(std::size_t count, std::string_view noun);

/// Returns "a, b and c" with `last` = " and ".
[[nodiscard]] std::string listed(const std::vector<std::string>& words, std::string_view last = ", ");

/// Parses "8GB", "1.5 MiB" or "4096" as bytes, in capitals or not. Powers of 1000 are kB, MB, GB and TB; KiB, MiB, GiB
/// and TiB are powers of 1024. A bare number or B is bytes. Returns nothing for other text, or for less than 1 or more
/// than 2^62 bytes.
[[nodiscard]] std::optional<std::uint64_t> parse_byte_size(std::string_view text);

/// Returns bytes for people, in powers of 1000: "8 GB", "12.35 MB", "999 bytes". Digits are cut, not rounded up.
[[nodiscard]] std::string byte_size_text(std::uint64_t bytes);

}  // namespace gouge
