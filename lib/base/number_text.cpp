#include "lib/base/number_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "lib/base/leading_number.h"
#include "lib/base/letters.h"

namespace gouge {

namespace {

// std::from_chars also accepts "nan", "inf" and hexadecimal words; a number starts with a digit or a point.
bool looks_like_number(std::string_view text) {
  std::size_t i = (!text.empty() && (text[0] == '-')) ? 1 : 0;
  return i < text.size() && (is_digit(text[i]) || text[i] == '.');
}

bool has_negative_exponent(std::string_view text) {
  return text.find("e-") != std::string_view::npos || text.find("E-") != std::string_view::npos;
}

bool is_negative_zero_text(std::string_view text) {
  return text.front() == '-' && std::none_of(text.begin(), text.end(), [](char c) { return c >= '1' && c <= '9'; });
}

}  // namespace

std::string_view trim_blanks(std::string_view text) {
  const auto is_blank = [](char c) { return c == ' ' || (c >= '\t' && c <= '\r'); };
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::optional<double> parse_number(std::string_view text) {
  if (!text.empty() && text[0] == '+') {
    text.remove_prefix(1);
    if (!text.empty() && text[0] == '-') return std::nullopt;
  }
  if (const LeadingNumber number = leading_number(text); number.length > 0 && number.length == text.size())
    return number.value;
  if (!looks_like_number(text)) return std::nullopt;
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end != text.data() + text.size()) return std::nullopt;
  // std::from_chars leaves `value` alone if the number is out of range. A number too close to zero is zero; one too
  // large is invalid.
  if (error == std::errc::result_out_of_range && has_negative_exponent(text)) return 0.0;
  if (error != std::errc{} || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<long long> parse_integer(std::string_view text) {
  if (!text.empty() && text[0] == '+') text.remove_prefix(1);
  long long value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || end != text.data() + text.size() || error != std::errc{}) return std::nullopt;
  return value;
}

std::string exact_text(double value) {
  std::array<char, 40> buffer{};
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  const std::string_view text(buffer.data(), static_cast<std::size_t>(end - buffer.data()));
  return is_negative_zero_text(text) ? "0" : std::string(text);
}

std::string fixed_text(double value, int decimals) {
  std::array<char, 400> buffer{};
  const auto [end, error] =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals);
  std::string_view text(buffer.data(), static_cast<std::size_t>(end - buffer.data()));
  if (is_negative_zero_text(text)) text.remove_prefix(1);
  return std::string(text);
}

std::string display_text(double value, int decimals, Zeros zeros) {
  constexpr double kLargestFixed = 1e15;
  if (std::abs(value) >= kLargestFixed) {
    std::array<char, 40> buffer{};
    const auto [end, error] =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::scientific);
    return {buffer.data(), end};
  }
  std::string text = fixed_text(value, decimals);
  if (zeros == Zeros::kept || text.find('.') == std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string count_text(std::size_t count, std::string_view one, std::string_view many) {
  return std::to_string(count) + " " + std::string(count == 1 ? one : many);
}

std::string count_text(std::size_t count, std::string_view noun) {
  return count_text(count, noun, std::string(noun) + "s");
}

std::string listed(const std::vector<std::string>& words, std::string_view last) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? last : ", ";
    text += words[i];
  }
  return text;
}

namespace {

constexpr double kLargest = 4611686018427387904.0;  // 2^62

std::optional<double> bytes_per(std::string_view unit) {
  const std::string wanted = in_small_letters(unit);
  constexpr std::array<std::pair<std::string_view, double>, 10> kUnits{{{"", 1.0},
                                                                        {"b", 1.0},
                                                                        {"kb", 1e3},
                                                                        {"mb", 1e6},
                                                                        {"gb", 1e9},
                                                                        {"tb", 1e12},
                                                                        {"kib", 1024.0},
                                                                        {"mib", 1048576.0},
                                                                        {"gib", 1073741824.0},
                                                                        {"tib", 1099511627776.0}}};
  for (const auto& [name, bytes] : kUnits) {
    if (wanted == name) return bytes;
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::uint64_t> parse_byte_size(std::string_view text) {
  const std::size_t end = std::min(text.find_first_not_of("0123456789."), text.size());
  const std::optional<double> number = parse_number(text.substr(0, end));
  std::string_view unit = text.substr(end);
  if (unit.starts_with(' ')) unit.remove_prefix(1);
  const std::optional<double> each = bytes_per(unit);
  if (!number || !each) return std::nullopt;
  const double bytes = *number * *each;
  if (!(bytes >= 1) || !(bytes <= kLargest)) return std::nullopt;
  return static_cast<std::uint64_t>(bytes);
}

std::string byte_size_text(std::uint64_t bytes) {
  constexpr std::array<const char*, 5> kNames{"bytes", "kB", "MB", "GB", "TB"};
  std::size_t power = 0;
  std::uint64_t each = 1;
  while (power + 1 < kNames.size() && bytes / each >= 1000) {
    each *= 1000;
    ++power;
  }
  if (bytes == 1) return "1 byte";
  std::string text = std::to_string(bytes / each);
  const std::uint64_t hundredths = power == 0 ? 0 : bytes % each / (each / 100);
  if (hundredths > 0) {
    text += "." + std::to_string(hundredths / 10);
    if (hundredths % 10 > 0) text += std::to_string(hundredths % 10);
  }
  return text + " " + kNames[power];
}

}  // namespace gouge
