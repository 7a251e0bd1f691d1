#pragma once

#include <string>
#include <string_view>

namespace gouge {

/// UTF-8 text in ASCII, for the stroke font: accents dropped, "ß" as "ss", "µ" as "u", "°" as "deg",
/// typographic dashes and quotes as plain ones, anything else (and broken UTF-8) as "?".
[[nodiscard]] std::string ascii_text(std::string_view utf8);

}  // namespace gouge
