#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

// Text from outside (names of files, tools and operations, words of a toolpath) on its way to a terminal. A caller that
// puts such a name into a line of text passes it, or the whole line, through printable() once. Data (JSON, CSV,
// toolpaths) never passes through it.

namespace gouge {

/// Returns `text` as one line that shows every character in it. A character that a terminal would obey or hide is
/// written as an escape.
/// (1) The controls (C0, DEL, C1: \n, \t, \x1b, \u009b), and bytes that are not UTF-8 (\xff).
/// (2) Line separators, marks of direction, characters without width, fillers and tags (\u202e, \U000e0041).
/// The result is UTF-8 and printable(printable(text)) == printable(text): a backslash stays one.
[[nodiscard]] std::string printable(std::string_view text);

/// Columns a terminal gives to a printable text: combining marks take none, Chinese and Japanese characters
/// two. The same in every locale.
[[nodiscard]] std::size_t display_width(std::string_view text);

/// Returns printable(text), followed by blanks up to `width` columns. Wider text stays as it is.
[[nodiscard]] std::string padded(std::string_view text, std::size_t width);

struct CodePoint {
  char32_t value = 0;
  std::size_t bytes = 1;  ///< how many of the text it takes
};

/// Returns the code point whose well-formed sequence begins at `at` (RFC 3629: no overlong forms, no surrogates,
/// nothing above U+10FFFF); nothing where there is none. Requires at < text.size().
[[nodiscard]] std::optional<CodePoint> decode_utf8(std::string_view text, std::size_t at);

/// Returns whether all of the text is well-formed.
[[nodiscard]] bool is_utf8(std::string_view text);

/// Returns the text with every byte that is not UTF-8 replaced by U+FFFD.
[[nodiscard]] std::string valid_utf8(std::string_view text);

}  // namespace gouge
