#include "postproc/cldata/language/text.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "lib/base/letters.h"
#include "lib/base/printable_text.h"

namespace gouge {
namespace {

constexpr std::size_t kLongestName = 200;
constexpr std::size_t kLongestQuote = 40;

std::string printable(std::string_view text, std::size_t longest) {
  std::string result;
  const bool is_latin1 = !is_utf8(text);
  for (std::size_t i = 0; i < text.size() && result.size() < longest;) {
    const unsigned byte = static_cast<unsigned char>(text[i]);
    const std::size_t length = is_latin1 ? 1 : decode_utf8(text, i)->bytes;
    if (byte < 0x20 || byte == 0x7f || (is_latin1 && byte >= 0x80 && byte < 0xa0)) {
      // control characters are dropped
    } else if (is_latin1 && byte >= 0x80) {
      result += static_cast<char>(0xc0U | (byte >> 6U));
      result += static_cast<char>(0x80U | (byte & 0x3fU));
    } else {
      result += text.substr(i, length);
    }
    i += length;
  }
  return result;
}

}  // namespace

std::string shown_text(std::string_view text, std::size_t longest) { return printable(text, longest); }

std::string_view trim(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::size_t blanks_before(std::string_view bytes, std::size_t at) {
  std::size_t count = 0;
  while (count < at && bytes[at - count - 1] == ' ') ++count;
  return count;
}

std::string line_end_of(std::string_view bytes) {
  const std::size_t end = bytes.find('\n');
  return end != std::string_view::npos && end > 0 && bytes[end - 1] == '\r' ? "\r\n" : "\n";
}

int compare_ignoring_case(std::string_view a, std::string_view b) {
  const std::size_t shorter = std::min(a.size(), b.size());
  for (std::size_t i = 0; i < shorter; ++i) {
    const char x = capital(a[i]);
    const char y = capital(b[i]);
    if (x != y) return static_cast<unsigned char>(x) < static_cast<unsigned char>(y) ? -1 : 1;
  }
  return a.size() == b.size() ? 0 : a.size() < b.size() ? -1 : 1;
}

bool equals_ignoring_case(std::string_view a, std::string_view b) {
  return a.size() == b.size() && compare_ignoring_case(a, b) == 0;
}

bool is_one_of(std::string_view text, std::span<const std::string_view> words) {
  return std::ranges::any_of(words, [&](std::string_view word) { return equals_ignoring_case(text, word); });
}

bool starts_with_ignoring_case(std::string_view text, std::string_view start) {
  return text.size() >= start.size() && compare_ignoring_case(text.substr(0, start.size()), start) == 0;
}

bool is_one_letter_off(std::string_view a, std::string_view b) {
  if (a.size() > b.size()) std::swap(a, b);
  std::size_t same = 0;
  while (same < a.size() && equals_ignoring_case(a.substr(same, 1), b.substr(same, 1))) ++same;
  if (a.size() + 1 == b.size()) return equals_ignoring_case(a.substr(same), b.substr(same + 1));
  if (a.size() != b.size() || same == a.size()) return false;
  if (equals_ignoring_case(a.substr(same + 1), b.substr(same + 1))) return true;
  return same + 1 < a.size() && equals_ignoring_case(a.substr(same, 1), b.substr(same + 1, 1)) &&
         equals_ignoring_case(a.substr(same + 1, 1), b.substr(same, 1)) &&
         equals_ignoring_case(a.substr(same + 2), b.substr(same + 2));
}

std::string name_text(std::string_view text) {
  text = trim(text);
  if (text.size() >= 2 && text.front() == '\'' && text.back() == '\'') {
    text = trim(text.substr(1, text.size() - 2));
  }
  return printable(text, kLongestName);
}

std::string quoted_text(std::string_view text) {
  text = trim(text);
  const std::string shown = printable(text.substr(0, kLongestQuote), 2 * kLongestQuote);
  return '"' + shown + (text.size() > kLongestQuote ? "...\"" : "\"");
}

}  // namespace gouge
