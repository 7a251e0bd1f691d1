#include "lib/base/number_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace gouge {
namespace {

// std::from_chars takes "nan", "inf" and hexadecimal words too; a number starts with a digit or a point.
bool looks_like_number(std::string_view text) {
  std::size_t i = (!text.empty() && (text[0] == '-')) ? 1 : 0;
  return i < text.size() && ((text[i] >= '0' && text[i] <= '9') || text[i] == '.');
}

bool has_negative_exponent(std::string_view text) {
  return text.find("e-") != std::string_view::npos || text.find("E-") != std::string_view::npos;
}

bool is_negative_zero_text(std::string_view text) {
  return text.front() == '-' &&
         std::none_of(text.begin(), text.end(), [](char c) { return c >= '1' && c <= '9'; });
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  if (!text.empty() && text[0] == '+') {
    text.remove_prefix(1);
    if (!text.empty() && text[0] == '-') return std::nullopt;
  }
  if (!looks_like_number(text)) return std::nullopt;
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end != text.data() + text.size()) return std::nullopt;
  // Out of range leaves `value` alone; a number too small to tell from zero is zero, one too large is none.
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

}  // namespace gouge
