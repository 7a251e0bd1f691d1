#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

// Functions for text from outside (names of files, tools and operations, words of a toolpath) that goes to a terminal.
// A caller that puts such a name into a line passes the name, or the whole line, through printable() once. Data (JSON,
// CSV, toolpaths) never passes through it.

namespace gouge {

/// Returns `text` as one line that shows every character. A character that a terminal would obey or hide is written as
/// an escape.
/// (1) Control characters (C0, DEL, C1: \n, \t, \x1b, \u009b), and bytes that are not UTF-8 (\xff).
/// (2) Line separators, marks of direction, characters without width, fillers and tags (\u202e, \U000e0041).
/// The result is UTF-8, and printable(printable(text)) == printable(text): a backslash is not escaped.
[[nodiscard]] std::string printable(std::string_view text);

/// Returns the number of columns that a terminal uses for a printable text. Combining marks use none, Chinese and
/// Japanese characters two. The colours of `painted` use none. The result is the same in every locale.
[[nodiscard]] std::size_t display_width(std::string_view text);

/// Returns printable(text), padded with blanks to `width` columns. Wider text is not cut.
[[nodiscard]] std::string padded(std::string_view text, std::size_t width);

/// Returns `text` in lines of at most `width` characters, broken at blanks, each but the first after `indent` blanks,
/// which count. Line breaks of the text stay, and lines that begin with a blank are examples and stay as they are.
[[nodiscard]] std::string wrapped(std::string_view text, std::size_t width, std::size_t indent);

struct CodePoint {
  char32_t value = 0;
  std::size_t bytes = 1;  ///< number of bytes that it takes in the text
};

/// Returns the code point whose well-formed sequence begins at `at` (RFC 3629: no overlong forms, no surrogates,
/// nothing above U+10FFFF). Returns nothing if no such sequence begins there. Requires at < text.size().
[[nodiscard]] std::optional<CodePoint> decode_utf8(std::string_view text, std::size_t at);

/// Returns whether all of the text is well-formed UTF-8.
[[nodiscard]] bool is_utf8(std::string_view text);

/// Returns the text with every byte that is not UTF-8 replaced by U+FFFD.
[[nodiscard]] std::string valid_utf8(std::string_view text);

}  // namespace gouge
