#include "lib/base/byte_size.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "lib/base/number_text.h"

namespace gouge {
namespace {

constexpr double kLargest = 4611686018427387904.0;  // 2^62

std::optional<double> bytes_per(std::string_view unit) {
  std::string small(unit);
  std::transform(small.begin(), small.end(), small.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
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
    if (small == name) return bytes;
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
