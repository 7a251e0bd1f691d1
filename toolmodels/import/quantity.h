#pragma once

#include <optional>
#include <string>
#include <string_view>

// Numbers with a unit as texts contain them: "6.0000 mm", "0,69488188976378 in", "20 deg", "0.25\"".

namespace gouge {

enum class QuantityUnit { none, mm, inch, degree };

struct Quantity {
  double value = 0;  ///< in mm or degrees, or the bare number
  QuantityUnit unit = QuantityUnit::none;
  bool has_decimal_comma = false;
};

/// Parses a quantity. A single comma without a point is a decimal comma. A text with both is refused, because its
/// meaning is uncertain.
[[nodiscard]] std::optional<Quantity> parse_quantity(std::string_view text);

/// Cleans a text. Valid UTF-8 stays as it is, and any other text is read as Latin-1. Control characters become blanks.
[[nodiscard]] std::string clean_text(std::string_view text);

/// Returns the letters and digits of the text in lower case. Names of shapes and classes are compared in this form.
[[nodiscard]] std::string plain_word(std::string_view text);

}  // namespace gouge
