#include "lib/base/printable_text.h"

#include <wchar.h>
#include <algorithm>
#include <array>
#include <clocale>

namespace gouge {

namespace {

struct Range {
  char32_t first, last;
};

// Characters that are invisible or change the direction of text. In Unicode 15 they are Cc, Cf without the signs of
// numbers, Zl, Zp, Default_Ignorable_Code_Point without variation selectors, and the noncharacters of the first plane.
constexpr std::array<Range, 20> kUnseen = {
    {{0x00, 0x1F},     {0x7F, 0x9F},     {0xAD, 0xAD},       {0x34F, 0x34F},     {0x61C, 0x61C},
     {0x115F, 0x1160}, {0x17B4, 0x17B5}, {0x180B, 0x180F},   {0x200B, 0x200F},   {0x2028, 0x202E},
     {0x2060, 0x206F}, {0x3164, 0x3164}, {0xFDD0, 0xFDEF},   {0xFEFF, 0xFEFF},   {0xFFA0, 0xFFA0},
     {0xFFF0, 0xFFFB}, {0xFFFE, 0xFFFF}, {0x1BCA0, 0x1BCA3}, {0x1D173, 0x1D17A}, {0xE0000, 0xE0FFF}}};

bool is_unseen(char32_t c) {
  return std::any_of(kUnseen.begin(), kUnseen.end(), [c](const Range& r) { return c >= r.first && c <= r.last; });
}

bool is_plain_ascii(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c >= 0x20 && c < 0x7F; });
}

std::string hexadecimal(const char* prefix, char32_t value, int digits) {
  std::string text = prefix;
  for (int shift = 4 * (digits - 1); shift >= 0; shift -= 4)
    text += "0123456789abcdef"[(value >> static_cast<unsigned>(shift)) & 15U];
  return text;
}

std::string escaped(char32_t c) {
  if (c == '\n') return "\\n";
  if (c == '\r') return "\\r";
  if (c == '\t') return "\\t";
  if (c < 0x100) return hexadecimal(c < 0x80 ? "\\x" : "\\u00", c, 2);
  return c < 0x10000 ? hexadecimal("\\u", c, 4) : hexadecimal("\\U", c, 8);
}

// Returns the width from the C library's table, in a locale of our own: the caller's locale may know only ASCII.
int width_of(char32_t c) {
  static const locale_t utf8 = ::newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr);
  if (c < 0x7F || utf8 == nullptr) return 1;
  const locale_t before = ::uselocale(utf8);
  const int width = ::wcwidth(static_cast<wchar_t>(c));
  ::uselocale(before);
  return width < 0 ? 1 : width;
}

}  // namespace

std::string printable(std::string_view text) {
  if (is_plain_ascii(text)) return std::string(text);
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const std::optional<CodePoint> c = decode_utf8(text, at);
    if (!c) {
      out += hexadecimal("\\x", static_cast<unsigned char>(text[at]), 2);
    } else if (is_unseen(c->value)) {
      out += escaped(c->value);
    } else {
      out += text.substr(at, c->bytes);
    }
    at += c ? c->bytes : 1;
  }
  return out;
}

std::size_t display_width(std::string_view text) {
  std::size_t width = 0;
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] == '\x1b') {  // a colour, up to its m
      at = std::min(text.find('m', at), text.size() - 1) + 1;
      continue;
    }
    const std::optional<CodePoint> c = decode_utf8(text, at);
    width += c ? static_cast<std::size_t>(width_of(c->value)) : 1;
    at += c ? c->bytes : 1;
  }
  return width;
}

std::string padded(std::string_view text, std::size_t width) {
  std::string out = printable(text);
  const std::size_t taken = display_width(out);
  return out.append(width > taken ? width - taken : 0, ' ');
}

std::optional<CodePoint> decode_utf8(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(at);
  if (first < 0x80) return CodePoint{first, 1};
  const std::size_t bytes = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || at + bytes > text.size()) return std::nullopt;
  char32_t value = first & (0xFFU >> (bytes + 1));
  for (std::size_t k = 1; k < bytes; ++k) {
    if ((byte(at + k) & 0xC0U) != 0x80U) return std::nullopt;
    value = (value << 6U) | (byte(at + k) & 0x3FU);
  }
  const bool is_overlong = (bytes == 3 && value < 0x800) || (bytes == 4 && value < 0x10000);
  const bool is_surrogate = value >= 0xD800 && value <= 0xDFFF;
  if (is_overlong || is_surrogate || value > 0x10FFFF) return std::nullopt;
  return CodePoint{value, bytes};
}

bool is_utf8(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::optional<CodePoint> c = decode_utf8(text, at);
    if (!c) return false;
    at += c->bytes;
  }
  return true;
}

std::string valid_utf8(std::string_view text) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const std::optional<CodePoint> c = decode_utf8(text, at);
    out += c ? text.substr(at, c->bytes) : std::string_view("\xEF\xBF\xBD");
    at += c ? c->bytes : 1;
  }
  return out;
}

std::string wrapped(std::string_view text, std::size_t width, std::size_t indent) {
  const std::string new_line = "\n" + std::string(indent, ' ');
  std::string out;
  std::size_t used = indent;
  for (std::size_t at = 0; at < text.size();) {
    const bool is_example = (at == 0 || text[at - 1] == '\n') && text[at] == ' ';
    const std::size_t end = std::min(text.find_first_of(is_example ? "\n" : " \n", at), text.size());
    const std::string_view word = text.substr(at, end - at);
    const bool is_first = used == indent;
    if (!is_first && used + 1 + display_width(word) > width) {
      out += new_line;
      used = indent;
    } else if (!is_first && !word.empty()) {
      out += " ";
      ++used;
    }
    out += word;
    used += display_width(word);
    at = end + 1;
    if (end < text.size() && text[end] == '\n') {
      out += new_line;
      used = indent;
    }
  }
  return out;
}

}  // namespace gouge
