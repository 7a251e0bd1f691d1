#include "postproc/cldata/language/arguments.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include "lib/base/leading_number.h"
#include "lib/base/number_text.h"
#include "postproc/cldata/language/text.h"

namespace gouge {
namespace {

enum class Role : std::uint8_t { text, comma, separator };

constexpr std::array<Role, 256> kRoles = [] {
  std::array<Role, 256> roles{};
  for (std::size_t byte = 0; byte < roles.size(); ++byte) {
    const char c = static_cast<char>(byte);
    if (c == ',') roles[byte] = Role::comma;
    if (is_blank(c) || c == '(' || c == ')' || c == '/') roles[byte] = Role::separator;
  }
  return roles;
}();

Role role_of(char c) { return kRoles[static_cast<unsigned char>(c)]; }

// Returns the number. It may have the exponent of Fortran, in which old systems are written: "-2.D-1". Without the
// point it is a word.
std::optional<double> number_of(std::string_view text) {
  if (const std::optional<double> value = parse_number(text)) return value;
  const std::size_t exponent = text.find_first_of("dD");
  if (exponent == std::string_view::npos || text.find('.') >= exponent) return std::nullopt;
  std::string copy(text);
  copy[exponent] = 'E';
  return parse_number(copy);
}

// Returns the number of digits after the point, minus the exponent; nothing for an integer.
std::optional<int> decimals_of(std::string_view text) {
  const std::size_t end = std::min(text.find_first_of("eEdD"), text.size());
  const std::size_t point = std::min(text.find('.'), end);
  const int decimals = static_cast<int>(end - std::min(point + 1, end));
  const std::optional<double> exponent =
      end < text.size() ? parse_number(text.substr(end + 1)) : std::optional<double>(0);
  if (!exponent || std::abs(*exponent) > 300) return std::nullopt;
  const int moved = decimals - static_cast<int>(*exponent);
  return moved > 0 ? std::optional<int>(moved) : std::nullopt;
}

bool begins_number(char c) { return is_digit(c) || c == '.'; }

}  // namespace

void split_arguments(const Statement& statement, std::vector<Argument>& arguments) {
  if (statement.is_decoded) {
    arguments = statement.decoded;
    return;
  }
  if (statement.is_split) {
    arguments = statement.arguments;
    return;
  }
  arguments.clear();
  bool is_expecting = true;  // after a comma, or at the start: a further comma means an empty argument
  for (const std::string_view piece : statement.pieces) {
    for (std::size_t i = 0; i < piece.size() && arguments.size() < kMaxArguments;) {
      const Role role = role_of(piece[i]);
      if (role == Role::text) {
        is_expecting = false;
        // Nearly all arguments are plain numbers, whose end is found with their value.
        const LeadingNumber number = leading_number(piece.substr(i));
        const std::size_t after = i + number.length;
        if (number.length > 0 && (after == piece.size() || role_of(piece[after]) != Role::text)) {
          arguments.push_back({piece.substr(i, number.length), number.value});
          i = after;
          continue;
        }
        const std::size_t begin = i;
        while (i < piece.size() && role_of(piece[i]) == Role::text) ++i;
        const std::string_view text = piece.substr(begin, i - begin);
        arguments.push_back({text, number_of(text)});
        continue;
      }
      if (role == Role::comma) {
        if (is_expecting) arguments.push_back({piece.substr(i, 0), std::nullopt});
        is_expecting = true;
      }
      ++i;
    }
  }
}

const Argument* find_word_argument(std::span<const Argument> arguments) {
  const auto it = std::ranges::find_if(arguments, [](const Argument& a) { return !a.number; });
  return it == arguments.end() ? nullptr : &*it;
}

bool has_argument(std::span<const Argument> arguments, std::string_view word) {
  return std::ranges::any_of(arguments, [&](const Argument& a) { return equals_ignoring_case(a.text, word); });
}

std::optional<double> number_after(std::span<const Argument> arguments, std::string_view word) {
  for (std::size_t i = 0; i + 1 < arguments.size(); ++i) {
    if (equals_ignoring_case(arguments[i].text, word)) return arguments[i + 1].number;
  }
  return std::nullopt;
}

NumberCount count_numbers(std::span<const Argument> arguments) {
  NumberCount numbers;
  for (const Argument& argument : arguments) {
    if (!argument.number) continue;
    ++numbers.count;
    if (*argument.number < 0) ++numbers.negative;
  }
  return numbers;
}

double rounding_of(std::span<const Argument> arguments) {
  int most = 0;
  for (const Argument& argument : arguments) {
    if (argument.number) most = std::max(most, decimals_of(argument.text).value_or(0));
  }
  return most == 0 ? 0 : 0.5 * std::pow(10.0, -most);
}

double rounding_of_points(std::span<const Argument> arguments) {
  constexpr int kUnpadded = 4;
  int most = 0;
  for (const Argument& argument : arguments) {
    if (!argument.number) continue;
    const int written = decimals_of(argument.text).value_or(0);
    const std::string_view unpadded = argument.text.substr(0, argument.text.find_last_not_of('0') + 1);
    most = std::max({most, std::min(written, kUnpadded), decimals_of(unpadded).value_or(0)});
  }
  return most == 0 ? 0 : 0.5 * std::pow(10.0, -most);
}

namespace {

// Returns whether a blank, or another control character, is before a number and not after a comma. Most bytes of a file
// are tested so; without a branch in the loop, the compiler tests many at once.
bool may_have_bare_blank(std::string_view text) {
  const char* const at = text.data();
  const std::size_t count = text.size();
  unsigned char found = 0;
  for (std::size_t i = 1; i + 1 < count; ++i) {
    const bool is_low = static_cast<unsigned char>(at[i]) <= ' ';
    const bool is_before_number = is_digit(at[i + 1]) | (at[i + 1] == '.');
    found = static_cast<unsigned char>(found | (is_low & (at[i - 1] != ',') & is_before_number));
  }
  return found != 0;
}

}  // namespace

// Tests only statements with a comma elsewhere, and statements that name a tool or its sizes. In other ones two numbers
// without a comma may be separate.
bool has_blank_in_number(const Statement& statement) {
  if (statement.is_decoded) return false;
  static constexpr WordSet kOfTools = {Word::cutter, Word::load, Word::loadtl, Word::toolno, Word::tldata};
  const auto has_comma = [](std::string_view piece) { return piece.find(',') != std::string_view::npos; };
  if (!kOfTools.has(statement.word) && std::ranges::none_of(statement.pieces, has_comma)) return false;
  for (const std::string_view piece : statement.pieces) {
    if (!may_have_bare_blank(piece)) continue;
    for (std::size_t i = 1; i + 1 < piece.size(); ++i) {
      if (!is_blank(piece[i]) || piece[i - 1] == ',' || !begins_number(piece[i + 1])) continue;
      const std::string_view before = trim(piece.substr(0, i));
      if (before.empty() || !begins_number(before.back())) continue;
      const std::size_t first = before.find_last_of(" \t,()/") + 1, last = piece.find_first_of(" \t,()/", i + 1);
      const std::string joined =
          std::string(before.substr(first)) + std::string(piece.substr(i + 1, std::min(last, piece.size()) - i - 1));
      if (number_of(joined)) return true;
    }
  }
  return false;
}

bool has_damaged_argument(std::span<const Argument> arguments) {
  return std::ranges::any_of(arguments, [](const Argument& argument) {
    return !argument.number && argument.text.find_first_not_of("+-.0123456789") == std::string_view::npos;
  });
}

bool has_repeated_word(std::span<const Argument> arguments) {
  // no understood statement has more; all pairs are compared, which must stay fast
  constexpr std::size_t kMaxWords = 64;
  std::vector<std::string_view> words;
  for (const Argument& argument : arguments) {
    if (argument.number || argument.text.empty()) continue;
    const auto is_same = [&](std::string_view word) { return equals_ignoring_case(word, argument.text); };
    if (words.size() == kMaxWords || std::ranges::any_of(words, is_same)) return true;
    words.push_back(argument.text);
  }
  return false;
}

}  // namespace gouge
