#include "postproc/cldata/arguments.h"

#include <algorithm>

#include "lib/base/number_text.h"
#include "postproc/cldata/text.h"

namespace gouge {
namespace {

constexpr bool is_soft_separator(char c) {
  return is_blank(c) || c == '(' || c == ')' || c == '/';
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
    for (std::size_t i = 0; i < piece.size();) {
      if (is_soft_separator(piece[i])) {
        ++i;
      } else if (piece[i] == ',') {
        if (is_expecting) arguments.push_back({piece.substr(i, 0), std::nullopt});
        is_expecting = true;
        ++i;
      } else {
        const std::size_t begin = i;
        while (i < piece.size() && piece[i] != ',' && !is_soft_separator(piece[i])) ++i;
        const std::string_view text = piece.substr(begin, i - begin);
        arguments.push_back({text, parse_number(text)});
        is_expecting = false;
      }
    }
  }
}

const Argument* find_word_argument(std::span<const Argument> arguments) {
  const auto it =
      std::find_if(arguments.begin(), arguments.end(), [](const Argument& a) { return !a.number; });
  return it == arguments.end() ? nullptr : &*it;
}

bool has_argument(std::span<const Argument> arguments, std::string_view word) {
  return std::any_of(arguments.begin(), arguments.end(),
                     [&](const Argument& a) { return equals_ignoring_case(a.text, word); });
}

}  // namespace gouge
