#pragma once

#include <cstdint>
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

/// A set of capital letters.
class CapitalSet {
 public:
  constexpr CapitalSet() = default;
  /// Requires capital letters.
  constexpr explicit CapitalSet(std::string_view letters) {
    for (const char letter : letters) add(letter);
  }
  /// Requires a capital letter.
  constexpr void add(char letter) { bits_ |= bit_of(letter); }
  [[nodiscard]] constexpr bool has(char c) const { return is_capital(c) && (bits_ & bit_of(c)) != 0; }
  [[nodiscard]] constexpr bool has_any(const CapitalSet& other) const { return (bits_ & other.bits_) != 0; }

 private:
  [[nodiscard]] static constexpr std::uint32_t bit_of(char letter) {
    return std::uint32_t{1} << static_cast<unsigned>(letter - 'A');
  }

  std::uint32_t bits_ = 0;
};

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
