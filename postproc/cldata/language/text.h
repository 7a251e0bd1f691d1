#pragma once

#include <span>
#include <string>
#include <string_view>

#include "lib/base/file_kind.h"
#include "lib/base/letters.h"

// The bytes of a CL file as words. Upper and lower case are equal everywhere in CL data.

namespace gouge {

[[nodiscard]] constexpr bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v' || c == '\x1a';
}

/// Returns whether a character belongs to words: letters, digits, `_` and `-`.
[[nodiscard]] constexpr bool is_word_character(char c) { return is_letter(c) || is_digit(c) || c == '_' || c == '-'; }

/// Returns `text` in UTF-8 without control characters. It is cut after the letter that reaches `longest` bytes. Bytes
/// that are not UTF-8 are read as Latin-1.
[[nodiscard]] std::string shown_text(std::string_view text, std::size_t longest);

[[nodiscard]] std::string_view trim(std::string_view text);

/// Returns the number of blanks immediately before `bytes[at]`.
[[nodiscard]] std::size_t blanks_before(std::string_view bytes, std::size_t at);

/// Returns the line end of the first line of `bytes`: carriage return and line feed, or one of them.
[[nodiscard]] std::string line_end_of(std::string_view bytes);

/// Returns < 0, 0 or > 0 if `a` sorts before, is equal to, or sorts after `b`. Letters are compared as capitals.
[[nodiscard]] int compare_ignoring_case(std::string_view a, std::string_view b);
[[nodiscard]] bool equals_ignoring_case(std::string_view a, std::string_view b);
/// Returns whether the text is one of `words`, compared by equals_ignoring_case.
[[nodiscard]] bool is_one_of(std::string_view text, std::span<const std::string_view> words);
[[nodiscard]] bool starts_with_ignoring_case(std::string_view text, std::string_view start);

/// Returns whether one character is missing, wrong or too many in one of the texts, or two neighbours are swapped.
/// Letters are compared as capitals. Returns false for equal texts.
[[nodiscard]] bool is_one_letter_off(std::string_view a, std::string_view b);

/// Returns `text` as a name for messages and JSON: trimmed, without quotes around it and control characters. Text that
/// is not UTF-8 is read as Latin-1 (CATIA writes the code page of its user). At most 200 bytes.
[[nodiscard]] std::string name_text(std::string_view text);

/// Returns `text` for use in a message: as from name_text, but cut to 40 bytes.
[[nodiscard]] std::string quoted_text(std::string_view text);

}  // namespace gouge
