#include "postproc/image/ascii_text.h"

#include <optional>
#include <string_view>
#include <utility>

#include "lib/base/printable_text.h"

namespace gouge {
namespace {

// U+00C0 to U+017F without their accents, one character each; letters that become two are handled before.
constexpr std::string_view kLatin =
    "AAAAAAACEEEEIIIIDNOOOOOxOUUUUYPsaaaaaaaceeeeiiiidnooooo/"
    "ouuuuypyAaAaAaCcCcCcCcDdDdEeEeEeEeEeGgGgGgGgHhHhIiIiIiIiIiIiJjKkkLlLlLlLlLlNnNnNnnNnOoOoOoOoRrRrRrSsSsSsSsTtTtTtUu"
    "UuUuUuUuUuWwYyYZzZzZzs";

// Characters with a fixed replacement.
constexpr std::pair<std::u32string_view, const char*> kSigns[] = {
    {U"\xA0", " "},         {U"\xB0", "deg"},        {U"\xB1", "+-"},
    {U"\xB2", "^2"},        {U"\xB5\x3BC", "u"},     {U"\xB7\x2022", "."},
    {U"\xC6", "AE"},        {U"\xE6", "ae"},         {U"\xDF", "ss"},
    {U"\x152", "OE"},       {U"\x153", "oe"},        {U"\x2010\x2011\x2012\x2013\x2014\x2212", "-"},
    {U"\x2018\x2019", "'"}, {U"\x201C\x201D", "\""}, {U"\x2026", "..."},
    {U"\x2264", "<="},      {U"\x2265", ">="},       {U"\x2300\x2205", "D"},
    {U"\x3B1", "alpha"},    {U"\x3B2", "beta"}};

std::string ascii_of(char32_t c) {
  for (const auto& [signs, text] : kSigns) {
    if (signs.find(c) != std::u32string_view::npos) return text;
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
