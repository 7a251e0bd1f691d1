#include "postproc/cldata/parsing/machine_tokens.h"

#include <algorithm>
#include <string>

#include "lib/base/number_text.h"

namespace gouge {
namespace {

// Returns the length of the number at the beginning of `text`, whose point may be a comma; 0 if there is none.
std::size_t take_number(std::string_view text, std::optional<double>& number) {
  std::string digits;
  std::size_t length = 0;
  for (; length < text.size(); ++length) {
    const char c = text[length];
    const bool is_comma = c == ',' && length + 1 < text.size() && is_digit(text[length + 1]);
    const bool is_sign = length == 0 && (c == '-' || c == '+');
    if (!is_digit(c) && c != '.' && !is_comma && !is_sign) break;
    digits += is_comma ? '.' : c;
  }
  number = parse_number(digits);
  return number ? length : 0;
}

// Returns the length of blanks and of brackets with their content, which are comments for most controls.
std::size_t skipped_length(std::string_view text) {
  std::size_t at = 0;
  while (at < text.size() && (is_blank(text[at]) || text[at] == ',' || text[at] == '(' || text[at] == ')')) {
    at = text[at] == '(' ? std::min(text.find(')', at), text.size()) : at + 1;
  }
  return at;
}

// Returns whether a word is too long for a code. No G code has four digits, so such a word is a cut name or a typing
// error.
bool is_too_long_for_a_code(std::string_view letters, std::string_view number) {
  constexpr std::size_t kMaxDigits = 3;
  const std::string_view whole = number.substr(0, number.find('.'));
  return equals_ignoring_case(letters, "G") && whole.size() > kMaxDigits;
}

MachineToken take_token(std::string_view& text) {
  MachineToken token;
  std::size_t at = 0;
  while (at < text.size() && (is_letter(text[at]) || text[at] == '_')) ++at;
  token.letters = text.substr(0, at);
  const std::size_t letters = at;
  while (at > 0 && at < text.size() && (text[at] == '=' || is_blank(text[at]))) ++at;
  const bool belongs =
      at == letters || letters == 1 || text.substr(letters, at - letters).find('=') != std::string_view::npos;
  std::size_t length = belongs ? take_number(text.substr(at), token.number) : 0;
  if (is_too_long_for_a_code(token.letters, text.substr(at, length))) {
    token.number.reset();
    length = 0;
  }
  if (length > 0) {
    token.is_glued = at == letters && letters > 0;
    at += length;
  } else {
    at = letters;
    if (at == 0) token.other = text[at++];
  }
  text.remove_prefix(at);
  return token;
}

}  // namespace

std::vector<MachineToken> machine_tokens(std::string_view text) {
  std::vector<MachineToken> tokens;
  for (text.remove_prefix(skipped_length(text)); !text.empty(); text.remove_prefix(skipped_length(text))) {
    if (text.front() == ';') break;
    if (text.front() == '"') {  // a name or a message
      text.remove_prefix(std::min(text.find('"', 1), text.size() - 1) + 1);
      continue;
    }
    tokens.push_back(take_token(text));
  }
  return tokens;
}

}  // namespace gouge
