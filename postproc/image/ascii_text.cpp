#include "postproc/image/ascii_text.h"

#include <optional>

#include "lib/base/utf8.h"

namespace gouge {
namespace {

// U+00C0 to U+017F without their accents, one character each; letters that need two are handled before.
constexpr std::string_view kLatin =
    "AAAAAAACEEEEIIIIDNOOOOOxOUUUUYPsaaaaaaaceeeeiiiidnooooo/"
    "ouuuuypyAaAaAaCcCcCcCcDdDdEeEeEeEeEeGgGgGgGgHhHhIiIiIiIiIiIiJjKkkLlLlLlLlLlNnNnNnnNnOoOoOoOoRrRrRrSsSsSsSsTtTtTtUu"
    "UuUuUuUuUuWwYyYZzZzZzs";

std::string ascii_of(char32_t c) {
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
    const std::optional<CodePoint> c = decode_utf8(utf8, at);
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
