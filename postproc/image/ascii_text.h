#pragma once

#include <string>
#include <string_view>

namespace gouge {

/// Returns UTF-8 text in ASCII, for the stroke font. Accents are dropped, "ß" becomes "ss", "µ" "u", and "°" "deg".
/// Typographic dashes and quotes become plain ones. Any other character, and broken UTF-8, becomes "?".
[[nodiscard]] std::string ascii_text(std::string_view utf8);

}  // namespace gouge
