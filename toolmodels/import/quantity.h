#pragma once

#include <optional>
#include <string>
#include <string_view>

// Numbers with a unit, as texts carry them: "6.0000 mm", "0,69488188976378 in", "20 deg", "0.25\"".

namespace gouge {

enum class QuantityUnit { none, mm, inch, degree };

struct Quantity {
  double value = 0;  ///< mm, degrees, or the bare number
  QuantityUnit unit = QuantityUnit::none;
  bool has_decimal_comma = false;
};

/// Parses a quantity. One comma and no point is a decimal comma; a text with both is refused, as no reading of it is
/// certain.
[[nodiscard]] std::optional<Quantity> parse_quantity(std::string_view text);

/// Cleans a text. Valid UTF-8 stays as it is, anything else is taken as Latin-1; control characters become blanks.
[[nodiscard]] std::string clean_text(std::string_view text);

/// Returns the text in lower case, letters and digits only, by which names of shapes and classes are compared.
[[nodiscard]] std::string plain_word(std::string_view text);

}  // namespace gouge
