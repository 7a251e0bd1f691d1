#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

#include "postproc/cldata/interpreting/interpreter.h"
#include "postproc/cldata/language/text.h"

// Numbers behind words that leave the cutter where it is: where a line end or a word was lost, they are the position
// that stood on the next line (COOLNT/ON,0,0,-5).

namespace gouge {
namespace {

// Whose own numbers may be as many as those of a position: the stock's box, the planes of clearance, a material.
constexpr std::array<std::string_view, 4> kOfManyNumbers = {"BOX", "CLEARP", "CLRSRF", "MATERL"};

}  // namespace

// A word that switches something has one or two numbers; SPINDL alone may have a negative one (the sense of rotation).
void Interpreter::take_harmless() {
  if (statement_->is_decoded || statement_->pieces.empty()) return;
  const auto is_called = [&](std::string_view word) { return equals_ignoring_case(statement_->major, word); };
  if (std::any_of(kOfManyNumbers.begin(), kOfManyNumbers.end(), is_called)) return;
  split_arguments(*statement_, arguments_);
  const NumberCount numbers = count_numbers(arguments_);
  const std::size_t most = numbers.has_negative ? (is_called("SPINDL") ? 1 : 0) : 2;
  if (numbers.count <= most) return;
  count_unknown();
  emit_unread();
}

// A feed rate with what may be its unit's number, and behind them what may be a position.
void Interpreter::distrust_numbers_of_feed() {
  const NumberCount numbers = count_numbers(arguments_);
  const std::size_t most = numbers.has_negative ? 2 : 3;
  if (statement_->is_decoded || numbers.count <= most) return;
  count_unknown();
  emit_unread();
}

}  // namespace gouge
