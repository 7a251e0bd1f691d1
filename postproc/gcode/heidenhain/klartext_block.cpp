#include "postproc/gcode/heidenhain/klartext_block.h"

#include <algorithm>
#include <array>

#include "lib/base/file_kind.h"
#include "lib/base/letters.h"
#include "lib/base/number_text.h"

namespace gouge {
namespace {

/// Removes the number of a block: digits before a blank, or alone.
void remove_block_number(std::string_view& line) {
  const auto digits = static_cast<std::size_t>(std::ranges::find_if_not(line, is_digit) - line.begin());
  if (digits == 0) return;
  if (digits < line.size() && line[digits] != ' ' && line[digits] != '\t' && line[digits] != '/') return;
  line = trim_blanks(line.substr(digits));
}

/// Returns whether text may begin a block. Text that begins with a long word that is no keyword is none: a short one may be
/// an address with its value, such as X+50.
bool may_begin_block(std::string capitals) {
  static constexpr std::array<std::string_view, 28> kLongKeywords = {
      "APPR", "BEGIN",   "CALL",    "CONTOUR", "CORRDATA", "CYCL",       "CYCLE",  "DECLARE", "FUNCTION", "GLOBAL",
      "GOTO", "INCLUDE", "OPEN",    "PATTERN", "PLANE",    "POLARKIN",   "PRESET", "PROBE",   "SECTION",  "STOP",
      "READ", "STRING",  "TABDATA", "TOOL",    "TRANS",    "MONITORING", "WAIT",   "WRITE"};
  constexpr std::size_t kMinLength = 4;
  std::ranges::transform(capitals, capitals.begin(), capital);
  std::string_view text = trim_blanks(capitals);
  if (text.empty()) return false;
  const auto length = static_cast<std::size_t>(std::ranges::find_if_not(text, is_capital) - text.begin());
  if (length < kMinLength) return true;
  return std::ranges::any_of(kLongKeywords, [&](std::string_view one) { return take_keywords(text, one); });
}

/// A carriage return within a comment may be a line end of another system, with a block behind it.
void check_comment(std::string_view comment, KlartextBlock& block) {
  for (std::size_t at = comment.find('\r'); at != std::string_view::npos; at = comment.find('\r', at + 1))
    if (may_begin_block(std::string(comment.substr(at + 1))))
      block.error = "a carriage return in a comment, and a block behind it";
}

/// Adds a line in capitals without its comment. Text between quotation marks stays.
void add_code(std::string_view line, KlartextBlock& block) {
  const auto is_mark = [](char c) { return c == '"' || c == ';'; };
  const auto plain = static_cast<std::size_t>(std::ranges::find_if(line, is_mark) - line.begin());
  const std::size_t begin = block.text.size();
  block.text += line.substr(0, plain);
  for (std::size_t i = begin; i < block.text.size(); ++i) block.text[i] = capital(block.text[i]);
  bool is_quoted = false;
  for (std::size_t i = plain; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '"') is_quoted = !is_quoted;
    if (c == ';' && !is_quoted) return check_comment(line.substr(i), block);
    block.text += is_quoted ? c : capital(c);
  }
}

bool take_tilde(std::string_view& line) {
  if (!line.ends_with('~')) return false;
  line.remove_suffix(1);
  return true;
}

/// Begins a block with its first line. Returns whether the next line belongs to it.
bool begin_block(std::string_view line, KlartextBlock& block) {
  line = without_byte_order_mark(line);
  line = trim_blanks(line);
  for (int mark = 0; mark < 2; ++mark) {
    if (mark == 0 || block.is_skippable) remove_block_number(line);
    if (!block.is_skippable && line.starts_with('/')) {
      block.is_skippable = true;
      line = trim_blanks(line.substr(1));
    }
  }
  if (line.starts_with(';') || line.starts_with('*')) {
    const std::size_t first = line.find_first_not_of(";*- \t");
    block.comment = first == std::string_view::npos ? std::string_view() : line.substr(first);
    std::ranges::replace(block.comment, '\r', ' ');
    check_comment(line, block);
    return false;
  }
  const bool goes_on = take_tilde(line);
  add_code(line, block);
  return goes_on;
}

}  // namespace

KlartextBlock read_klartext_line(std::string_view line) {
  KlartextBlock block;
  block.has_several_lines = begin_block(line, block);
  if (block.has_several_lines) block.text += " ~";  // no line follows
  block.text = trim_blanks(block.text);
  return block;
}

KlartextBlock read_klartext_block(const ProgramText& text, std::size_t index) {
  KlartextBlock block;
  bool goes_on = begin_block(text.line(index), block);
  block.has_several_lines = goes_on;
  while (goes_on && ++index < text.end()) {
    std::string_view line = trim_blanks(text.line(index));
    goes_on = take_tilde(line);
    block.text += ' ';
    add_code(line, block);
  }
  block.text = trim_blanks(block.text);
  block.next_index = std::min(index + 1, text.end());
  return block;
}

bool take_keywords(std::string_view& text, std::string_view keywords) {
  if (text.empty() || (is_capital(text[0]) && text[0] != keywords[0])) return false;
  std::string_view rest = text;
  while (!keywords.empty()) {
    const std::size_t length = std::min(keywords.find(' '), keywords.size());
    rest = trim_blanks(rest);
    if (!rest.starts_with(keywords.substr(0, length))) return false;
    rest.remove_prefix(length);
    const auto is_of_word = [](char c, char last) { return is_capital(c) || (is_digit(c) && is_digit(last)); };
    const bool goes_on = !rest.empty() && is_of_word(rest[0], keywords[length - 1]);
    if (goes_on) return false;
    keywords.remove_prefix(std::min(length + 1, keywords.size()));
  }
  text = trim_blanks(rest);
  return true;
}

}  // namespace gouge
