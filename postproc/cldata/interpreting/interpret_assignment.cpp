#include <algorithm>
#include <array>
#include <string_view>

#include "postproc/cldata/interpreting/interpreter.h"
#include "postproc/cldata/language/text.h"

// The source language of APT, which gives values to symbols: refused, because no CL data have them.

namespace gouge {
namespace {

constexpr std::size_t kLongestSymbol = 12;  // six to eight letters and a subscript
constexpr std::size_t kLongestTold = 48;

// "PL1=PLANE", "TP(1) =POINT", "D=.5": a symbol of the APT source language is being given a value.
bool is_assignment(std::string_view major) {
  const std::size_t sign = major.find('=');
  if (sign == std::string_view::npos || sign == 0) return false;
  const std::string_view symbol = trim(major.substr(0, sign));
  const auto is_symbol = [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '(' ||
           c == ')' || c == '_';
  };
  return symbol.size() <= kLongestSymbol && std::all_of(symbol.begin(), symbol.end(), is_symbol);
}

// The word of what an assignment gives to its symbol: PL1=PLANE/..
bool is_geometry(std::string_view value) {
  constexpr std::array<std::string_view, 20> kGeometry = {
      "POINT",  "LINE",   "PLANE",  "CIRCLE", "CYLNDR", "CONE",   "SPHERE", "ELLIPS", "HYPERB", "GCONIC",
      "LCONIC", "VECTOR", "MATRIX", "QADRIC", "TABCYL", "RLDSRF", "POLCON", "PATERN", "MACRO",  "SCURV"};
  return std::any_of(kGeometry.begin(), kGeometry.end(),
                     [&](std::string_view word) { return equals_ignoring_case(word, value); });
}

}  // namespace

void Interpreter::refuse_part_program(std::string_view what) {
  errors_.clear();
  errors_not_listed_ = 0;
  fail("path-part-program",
       "is an APT part program (" + quoted_text(what) +
           "); expected CL data with positions in numbers: run it through an APT system and "
           "check the CL file that gives");
  is_hopeless_ = true;
}

// What gives a symbol geometry is written in APT. A number given to a name is what logs hold as well: only beside a
// position is it part of a program.
bool Interpreter::take_assignment() {
  if (!is_assignment(statement_->major)) return false;
  if (is_geometry(trim(statement_->major.substr(statement_->major.find('=') + 1)))) {
    refuse_part_program(statement_->major);
    return true;
  }
  if (first_assignment_line_ == 0) {
    first_assignment_line_ = statement_->line;
    first_assignment_ = statement_->major.substr(0, kLongestTold);
  }
  count_unknown();
  return true;
}

void Interpreter::refuse_assignments() {
  const bool has_position = std::any_of(path_.moves.begin(), path_.moves.end(), [](const Move& move) {
    return !move.not_checked_reason.starts_with(Reasons::kUnread);
  });
  if (first_assignment_line_ == 0 || (!has_position && errors_.empty())) return;
  refuse_part_program(first_assignment_);
  errors_.back().line = first_assignment_line_;
}

}  // namespace gouge
