#include "postproc/cldata/interpreting/part_program.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "postproc/cldata/interpreting/emit.h"
#include "postproc/cldata/interpreting/reasons.h"
#include "postproc/cldata/interpreting/word_handlers.h"
#include "postproc/cldata/language/text.h"

// Handlers for INDEX and COPY of APT, which repeat positions with a shift.

namespace gouge {

namespace {

constexpr std::size_t kLongestSymbol = 12;  // six to eight letters and a subscript
constexpr std::size_t kLongestReported = 48;

// Returns whether a statement gives a value to a symbol of the APT source language: "PL1=PLANE", "TP(1) =POINT",
// "D=.5".
bool is_assignment(std::string_view major) {
  const std::size_t sign = major.find('=');
  if (sign == std::string_view::npos || sign == 0) return false;
  const std::string_view symbol = trim(major.substr(0, sign));
  const auto is_symbol = [](char c) { return is_digit(c) || is_letter(c) || c == '(' || c == ')' || c == '_'; };
  return symbol.size() <= kLongestSymbol && std::ranges::all_of(symbol, is_symbol);
}

// Returns whether an assignment gives its symbol a geometry word: PL1=PLANE/..
bool is_geometry(std::string_view value) {
  constexpr std::array<std::string_view, 20> kGeometry = {
      "POINT",  "LINE",   "PLANE",  "CIRCLE", "CYLNDR", "CONE",   "SPHERE", "ELLIPS", "HYPERB", "GCONIC",
      "LCONIC", "VECTOR", "MATRIX", "QADRIC", "TABCYL", "RLDSRF", "POLCON", "PATERN", "MACRO",  "SCURV"};
  return is_one_of(value, kGeometry);
}

}  // namespace

// Takes an assignment. Statements that define geometry belong to APT source. A name with a number also occurs in logs,
// so it is part of a program only beside a position.
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

namespace {

constexpr double kMaxCopies = 1000;

// Returns whether a copy that begins here would differ from the range: a RAPID is open, or the spindle has stopped or
// started.
bool is_border_open(const States& s, const IndexedMoves& range) {
  const bool has_moves = range.begin < s.in.moves();
  return s.feed.is_rapid_pending() ||
         (has_moves && s.in.path.moves[range.begin].is_spindle_stopped() != s.feed.is_spindle_stopped());
}

// Returns whether moves can be repeated: all are checked straight moves and arcs, with the present tool and frame.
bool is_repeatable(const States& s, const IndexedMoves& range) {
  if (range.begin == range.end || range.frames != s.frame_changes || range.begins_with_step) return false;
  if (range.is_border_open || is_border_open(s, range)) return false;
  const Moves& moves = s.in.path.moves;
  for (std::size_t i = range.begin; i < range.end; ++i) {
    const Move& move = moves[i];
    const bool can_begin = i > range.begin ? move.has_start : move.curve_kind == CurveKind::none;
    if (!can_begin || !move.not_checked_reason.empty() || move.curve_kind == CurveKind::spline ||
        move.kind == MoveKind::cycle || move.tool != moves[range.begin].tool)
      return false;
  }
  return moves[range.begin].tool == s.tool.index() && s.chain.is_start_certain() &&
         s.uncertainties.reason() == nullptr && s.cutcom.reason().empty() && !s.cycle.is_on() && !s.curve.is_open() &&
         !s.feed.is_kind_doubtful() && !s.control_motion.is_doubtful();
}

struct CopyStatement {
  int id = 0;
  Vec3 shift = Vec3::Zero();  // in the unit and frame of the file
  std::size_t copies = 1;
};

// Reads COPY/id,TRANSL,dx,dy,dz[,copies] or COPY/id,SAME[,copies].
std::optional<CopyStatement> read_copy(const std::vector<Argument>& arguments) {
  if (arguments.size() < 2 || !arguments[0].number) return std::nullopt;
  CopyStatement copy;
  copy.id = static_cast<int>(*arguments[0].number);
  const bool is_shifted = equals_ignoring_case(arguments[1].text, "TRANSL");
  if (!is_shifted && !equals_ignoring_case(arguments[1].text, "SAME")) return std::nullopt;
  const std::size_t numbers = is_shifted ? 3 : 0, size = arguments.size();
  if (size != 2 + numbers && size != 3 + numbers) return std::nullopt;
  if (std::any_of(arguments.begin() + 2, arguments.end(), [](const Argument& a) { return !a.number; }))
    return std::nullopt;
  if (is_shifted) copy.shift = {*arguments[2].number, *arguments[3].number, *arguments[4].number};
  const double copies = size == 3 + numbers ? *arguments.back().number : 1;
  if (!(copies >= 1 && copies <= kMaxCopies) || std::floor(copies) < copies) return std::nullopt;
  copy.copies = static_cast<std::size_t>(copies);
  return copy;
}

void repeat_move(States& s, std::size_t index, const Vec3& shift) {
  Move move = s.in.path.moves[index];
  move.line = s.in.line();
  move.statement = s.in.index();
  move.end.tip += shift;
  move.has_start = true;
  move.is_linked = false;
  move.begins_stretch = false;
  if (move.curve_kind == CurveKind::arc) {
    PathArc arc = s.in.path.arcs[move.curve];
    arc.center += shift;
    move.curve = s.in.path.arcs.size();
    s.in.make_room(s.in.path.arcs);
    s.in.path.arcs.push_back(arc);
  }
  Position position;
  position.form = PositionForm::unread;  // it has no statement of its own that could be changed
  position.tip_local = s.frame.to_local(move.end).tip;
  position.axis_local = s.frame.to_local(move.end).axis;
  append(s, move, position);
}

}  // namespace

// Takes INDEX. INDEX/id begins moves to repeat, and INDEX/id,NOMORE ends them.
void take_index(States& s) {
  const std::vector<Argument>& arguments = s.in.arguments;
  const bool is_end = arguments.size() == 2 && equals_ignoring_case(arguments[1].text, "NOMORE");
  if (arguments.empty() || !arguments[0].number || (arguments.size() > 1 && !is_end)) return take_part_program(s);
  IndexedMoves& range = s.indexed[static_cast<int>(*arguments[0].number)];
  if (is_end) {
    if (range.end == kNone) range.end = s.in.moves();
    range.is_border_open = range.is_border_open || is_border_open(s, range);
  } else {
    range = {s.in.moves(), kNone, s.frame_changes, s.feed.is_rapid_pending(), false};
  }
}

void take_copy(States& s) {
  const std::optional<CopyStatement> copy = read_copy(s.in.arguments);
  const auto found = copy ? s.indexed.find(copy->id) : s.indexed.end();
  if (found == s.indexed.end()) return take_repeat(s);
  resolve_tool(s);
  IndexedMoves range = found->second;
  if (range.end == kNone) range.end = s.in.moves();
  if (!is_repeatable(s, range) || (range.end - range.begin) * copy->copies > kMaxCopied) return take_repeat(s);
  const Vec3 shift = s.frame.to_part().direction(copy->shift * s.frame.mm_per_unit());
  for (std::size_t k = 1; k <= copy->copies; ++k) {
    for (std::size_t i = range.begin; i < range.end; ++i) repeat_move(s, i, static_cast<double>(k) * shift);
  }
  s.control_motion.note(MotionCode::other);
}

}  // namespace gouge
