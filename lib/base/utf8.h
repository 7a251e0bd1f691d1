#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace gouge {

struct CodePoint {
  char32_t value = 0;
  std::size_t bytes = 1;  ///< how many of the text it takes
};

/// The code point whose well-formed sequence begins at `at` (RFC 3629: no overlong forms, no surrogates,
/// nothing above U+10FFFF); nothing where there is none. Requires at < text.size().
[[nodiscard]] std::optional<CodePoint> decode_utf8(std::string_view text, std::size_t at);

/// Whether all of the text is well-formed.
[[nodiscard]] bool is_utf8(std::string_view text);

}  // namespace gouge
