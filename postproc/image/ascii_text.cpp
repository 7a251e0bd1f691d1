#include "postproc/image/ascii_text.h"

#include <cstdint>
#include <optional>

namespace gouge {
namespace {

struct CodePoint {
  std::uint32_t value = 0;
  std::size_t bytes = 1;
};

std::optional<CodePoint> decode(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint32_t>(static_cast<unsigned char>(text[i])); };
  const std::uint32_t first = byte(at);
  const std::size_t bytes = first < 0x80 ? 1 : first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (bytes == 1) return CodePoint{first, 1};
  if (first < 0xC2 || first > 0xF4 || at + bytes > text.size()) return std::nullopt;
  std::uint32_t value = first & (0xFFU >> (bytes + 1));
  for (std::size_t k = 1; k < bytes; ++k) {
    if ((byte(at + k) & 0xC0U) != 0x80U) return std::nullopt;
    value = (value << 6U) | (byte(at + k) & 0x3FU);
  }
  return CodePoint{value, bytes};
}

// U+00C0 to U+017F without their accents, one character each; letters that need two are handled before.
constexpr std::string_view kLatin =
    "AAAAAAACEEEEIIIIDNOOOOOxOUUUUYPsaaaaaaaceeeeiiiidnooooo/"
    "ouuuuypyAaAaAaCcCcCcCcDdDdEeEeEeEeEeGgGgGgGgHhHhIiIiIiIiIiIiJjKkkLlLlLlLlLlNnNnNnnNnOoOoOoOoRrRrRrSsSsSsSsTtTtTtUu"
    "UuUuUuUuUuWwYyYZzZzZzs";

std::string ascii_of(std::uint32_t c) {
  switch (c) {
    case 0xA0:
      return " ";
    case 0xB0:
      return "deg";
    case 0xB1:
      return "+-";
    case 0xB2:
      return "^2";
    case 0xB5:
    case 0x3BC:
      return "u";
    case 0xB7:
    case 0x2022:
      return ".";
    case 0xC6:
      return "AE";
    case 0xE6:
      return "ae";
    case 0xDF:
      return "ss";
    case 0x152:
      return "OE";
    case 0x153:
      return "oe";
    case 0x2010:
    case 0x2011:
    case 0x2012:
    case 0x2013:
    case 0x2014:
    case 0x2212:
      return "-";
    case 0x2018:
    case 0x2019:
      return "'";
    case 0x201C:
    case 0x201D:
      return "\"";
    case 0x2026:
      return "...";
    case 0x2264:
      return "<=";
    case 0x2265:
      return ">=";
    case 0x2300:
    case 0x2205:
      return "D";
    case 0x3B1:
      return "alpha";
    case 0x3B2:
      return "beta";
    default:
      break;
  }
  if (c >= 0xC0 && c < 0xC0 + kLatin.size()) return std::string(1, kLatin[c - 0xC0]);
  return "?";
}

}  // namespace

std::string ascii_text(std::string_view utf8) {
  std::string out;
  for (std::size_t at = 0; at < utf8.size();) {
    const std::optional<CodePoint> c = decode(utf8, at);
    if (!c) {
      out += '?';
      ++at;
      continue;
    }
    at += c->bytes;
    if (c->value >= 0x20 && c->value < 0x7F) {
      out += static_cast<char>(c->value);
    } else {
      out += c->value == '\t' ? " " : ascii_of(c->value);
    }
  }
  return out;
}

}  // namespace gouge
