#include "postproc/cldata/interpreting/part_program.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "postproc/cldata/interpreting/reasons.h"
#include "postproc/cldata/language/text.h"

namespace gouge {
namespace {

constexpr std::size_t kLongestSymbol = 12;  // six to eight letters and a subscript
constexpr std::size_t kLongestReported = 48;

// "PL1=PLANE", "TP(1) =POINT", "D=.5": a symbol of the APT source language is being given a value.
bool is_assignment(std::string_view major) {
  const std::size_t sign = major.find('=');
  if (sign == std::string_view::npos || sign == 0) return false;
  const std::string_view symbol = trim(major.substr(0, sign));
  const auto is_symbol = [](char c) { return is_digit(c) || is_letter(c) || c == '(' || c == ')' || c == '_'; };
  return symbol.size() <= kLongestSymbol && std::ranges::all_of(symbol, is_symbol);
}

// The word of what an assignment gives to its symbol: PL1=PLANE/..
bool is_geometry(std::string_view value) {
  constexpr std::array<std::string_view, 20> kGeometry = {
      "POINT",  "LINE",   "PLANE",  "CIRCLE", "CYLNDR", "CONE",   "SPHERE", "ELLIPS", "HYPERB", "GCONIC",
      "LCONIC", "VECTOR", "MATRIX", "QADRIC", "TABCYL", "RLDSRF", "POLCON", "PATERN", "MACRO",  "SCURV"};
  return is_one_of(value, kGeometry);
}

}  // namespace

// What gives a symbol geometry is written in APT. A number given to a name is what logs hold as well: only beside a
// position is it part of a program.
bool PartProgram::take_assignment() {
  const std::string_view major = in_.statement().major;
  if (!is_assignment(major)) return false;
  if (is_geometry(trim(major.substr(major.find('=') + 1)))) {
    in_.refuse_part_program(major);
    return true;
  }
  if (first_line_ == 0) {
    first_line_ = in_.line();
    first_ = major.substr(0, kLongestReported);
  }
  in_.count_unknown();
  return true;
}

void PartProgram::refuse_assignments() {
  if (first_line_ == 0) return;
  const Moves& moves = in_.path.moves;
  const bool has_position = std::ranges::any_of(
      moves, [](const Move& move) { return kind_of(move.not_checked_reason) != ReasonKind::may_be_unread; });
  if (has_position || in_.has_errors()) in_.refuse_part_program(first_, first_line_);
}

}  // namespace gouge
