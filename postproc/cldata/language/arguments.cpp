#include "postproc/cldata/language/arguments.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

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

// Also with the exponent of Fortran, in which old systems are written: "-2.D-1". Without the point it is a word.
std::optional<double> number_of(std::string_view text) {
  if (const std::optional<double> value = parse_number(text)) return value;
  const std::size_t exponent = text.find_first_of("dD");
  if (exponent == std::string_view::npos || text.find('.') >= exponent) return std::nullopt;
  std::string copy(text);
  copy[exponent] = 'E';
  return parse_number(copy);
}

}  // namespace

void split_arguments(const Statement& statement, std::vector<Argument>& arguments) {
  if (statement.is_decoded) {
    arguments = statement.decoded;
    return;
  }
  arguments.clear();
  bool is_expecting = true;  // after a comma, or at the start: a further comma means an empty argument
  for (const std::string_view piece : statement.pieces) {
    for (std::size_t i = 0; i < piece.size() && arguments.size() < kMostArguments;) {
      const Role role = role_of(piece[i]);
      if (role == Role::text) {
        const std::size_t begin = i;
        while (i < piece.size() && role_of(piece[i]) == Role::text) ++i;
        const std::string_view text = piece.substr(begin, i - begin);
        arguments.push_back({text, number_of(text)});
        is_expecting = false;
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

bool has_damaged_argument(std::span<const Argument> arguments) {
  return std::ranges::any_of(arguments, [](const Argument& argument) {
    return !argument.number && argument.text.find_first_not_of("+-.0123456789") == std::string_view::npos;
  });
}

bool has_repeated_word(std::span<const Argument> arguments) {
  constexpr std::size_t kMostWords = 64;  // of any statement that is understood; comparing all pairs must stay cheap
  std::vector<std::string_view> words;
  for (const Argument& argument : arguments) {
    if (argument.number || argument.text.empty()) continue;
    const auto is_same = [&](std::string_view word) { return equals_ignoring_case(word, argument.text); };
    if (words.size() == kMostWords || std::ranges::any_of(words, is_same)) return true;
    words.push_back(argument.text);
  }
  return false;
}

}  // namespace gouge
