#include "toolmodels/import/quantity.h"

#include <algorithm>
#include <array>
#include <numbers>

#include "lib/base/letters.h"
#include "lib/base/number_text.h"
#include "lib/base/printable_text.h"

namespace gouge {
namespace {

struct KnownUnit {
  std::string_view word;
  QuantityUnit unit;
  double factor;
};

constexpr double kDegrees = 180 / std::numbers::pi;
constexpr std::array kQuantityUnits = {KnownUnit{"", QuantityUnit::none, 1},
                                       KnownUnit{"mm", QuantityUnit::mm, 1},
                                       KnownUnit{"cm", QuantityUnit::mm, 10},
                                       KnownUnit{"m", QuantityUnit::mm, 1000},
                                       KnownUnit{"um", QuantityUnit::mm, 1e-3},
                                       KnownUnit{"\xC2\xB5m", QuantityUnit::mm, 1e-3},
                                       KnownUnit{"in", QuantityUnit::inch, 25.4},
                                       KnownUnit{"inch", QuantityUnit::inch, 25.4},
                                       KnownUnit{"\"", QuantityUnit::inch, 25.4},
                                       KnownUnit{"thou", QuantityUnit::inch, 0.0254},
                                       KnownUnit{"deg", QuantityUnit::degree, 1},
                                       KnownUnit{"\xC2\xB0", QuantityUnit::degree, 1},
                                       KnownUnit{"rad", QuantityUnit::degree, kDegrees}};

bool is_number_char(char c) { return (c >= '0' && c <= '9') || c == '.' || c == ',' || c == '+' || c == '-'; }

// Returns the end of the number. An e begins an exponent only before a digit or sign, as in "6e-1 mm"; otherwise it
// belongs to the unit.
std::size_t number_end(std::string_view text) {
  std::size_t end = 0;
  while (end < text.size()) {
    const bool is_exponent =
        (text[end] == 'e' || text[end] == 'E') && end + 1 < text.size() && is_number_char(text[end + 1]);
    if (!is_number_char(text[end]) && !is_exponent) break;
    ++end;
  }
  return end;
}

}  // namespace

std::optional<Quantity> parse_quantity(std::string_view text) {
  text = trim_blanks(text);
  const std::size_t end = number_end(text);
  std::string digits(text.substr(0, end));
  const std::string_view word = trim_blanks(text.substr(end));
  const auto unit =
      std::find_if(kQuantityUnits.begin(), kQuantityUnits.end(), [&](const KnownUnit& u) { return u.word == word; });
  if (unit == kQuantityUnits.end()) return std::nullopt;
  const auto commas = std::count(digits.begin(), digits.end(), ',');
  if (commas > 1 || (commas == 1 && digits.find('.') != std::string::npos)) return std::nullopt;
  std::replace(digits.begin(), digits.end(), ',', '.');
  const std::optional<double> number = parse_number(digits);
  if (!number) return std::nullopt;
  return Quantity{*number * unit->factor, unit->unit, commas == 1};
}

std::string clean_text(std::string_view text) {
  text = trim_blanks(text);
  const bool is_latin1 = !is_utf8(text);
  std::string clean;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7F) {
      clean += ' ';
    } else if (is_latin1 && byte >= 0x80) {
      clean += static_cast<char>(0xC0 | (byte >> 6));
      clean += static_cast<char>(0x80 | (byte & 0x3F));
    } else {
      clean += c;
    }
  }
  return clean;
}

std::string plain_word(std::string_view text) {
  std::string word;
  for (const char c : text) {
    if (is_letter(c) || is_digit(c)) word += small(c);
  }
  return word;
}

}  // namespace gouge
