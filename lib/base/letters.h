#pragma once

#include <string>
#include <string_view>

// Letters and digits of ASCII, whatever the locale. All other bytes stay as they are.

namespace gouge {

[[nodiscard]] constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
[[nodiscard]] constexpr bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }
[[nodiscard]] constexpr bool is_small(char c) { return c >= 'a' && c <= 'z'; }
[[nodiscard]] constexpr bool is_letter(char c) { return is_capital(c) || is_small(c); }

[[nodiscard]] constexpr char capital(char c) { return is_small(c) ? static_cast<char>(c - 'a' + 'A') : c; }
[[nodiscard]] constexpr char small(char c) { return is_capital(c) ? static_cast<char>(c - 'A' + 'a') : c; }

[[nodiscard]] inline std::string in_capitals(std::string_view text) {
  std::string made(text);
  for (char& c : made) c = capital(c);
  return made;
}

[[nodiscard]] inline std::string in_small_letters(std::string_view text) {
  std::string made(text);
  for (char& c : made) c = small(c);
  return made;
}

}  // namespace gouge
