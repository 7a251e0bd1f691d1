#include "postproc/cldata/reading/unit_guess.h"

#include <vector>

#include "postproc/cldata/language/arguments.h"
#include "postproc/cldata/language/words.h"

namespace gouge {
namespace {

constexpr std::size_t kMaxStatements = 20000;

bool is_position(Word word) {
  return word == Word::go_to || word == Word::from || word == Word::gohome || word == Word::tlon;
}

bool names_unit(Word word) { return word == Word::units || word == Word::fedrat || word == Word::cycle; }

}  // namespace

UnitGuess find_unit(std::string_view bytes, OpenStatements open) {
  UnitGuess guess;
  const auto source = open(bytes, 0, 1);
  Statement statement;
  std::vector<Argument> arguments;
  bool has_position = false;
  for (std::size_t i = 0; i < kMaxStatements && source->next(statement); ++i) {
    if (is_position(statement.word)) {
      has_position = true;
      if (guess.source != UnitGuess::Source::none) return guess;
    }
    if (!names_unit(statement.word)) continue;
    split_arguments(statement, arguments);
    for (const Argument& argument : arguments) {
      if (statement.word == Word::units) {
        const auto unit = unit_of_word(argument.text);
        if (unit && !has_position) {
          return {*unit, UnitGuess::Source::stated, std::string(statement.major) + "/" + std::string(argument.text),
                  statement.line};
        }
      } else if (guess.source == UnitGuess::Source::none) {
        if (const auto unit = unit_of_feed_word(argument.text))
          guess = {*unit, UnitGuess::Source::feed_word, std::string(argument.text), statement.line};
      }
    }
  }
  return guess;
}

}  // namespace gouge
