#include "postproc/report/csv_row.h"

#include <optional>

#include "lib/base/printable_text.h"

namespace gouge {
namespace {

// Returns whether a spreadsheet may take the text for a formula. It begins with =, +, - or @, also in full width, after
// blanks, quotes and an apostrophe that hides one. Tabs and carriage returns begin a new cell in some spreadsheets.
bool may_be_formula(std::string_view text) {
  using namespace std::string_view_literals;
  for (std::size_t at = 0; at < text.size();) {
    const std::optional<CodePoint> c = decode_utf8(text, at);
    if (!c) return false;
    if (U"=+-@\t\r\n\uFF1D\uFF0B\uFF0D\uFF20\u2212"sv.find(c->value) != std::u32string_view::npos) return true;
    if (U" \"'\u00A0\u200B\u3000\uFEFF"sv.find(c->value) == std::u32string_view::npos) return false;
    at += c->bytes;
  }
  return false;
}

}  // namespace

// Tests the text after separators of other locales too. There a row is split at semicolons, tabs and line ends, even
// within quotes that begin in the middle of it.
std::string without_formula(std::string_view text) {
  if (text.empty() || parse_number(text)) return std::string(text);
  std::string out;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const bool begins_cell = at == 0 || std::string_view(";\t\r\n").find(text[at - 1]) != std::string_view::npos;
    if (begins_cell && may_be_formula(text.substr(at))) out += '\'';
    out += text[at];
  }
  return out;
}

}  // namespace gouge
