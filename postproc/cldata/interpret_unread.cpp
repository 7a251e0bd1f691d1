#include <algorithm>
#include <cctype>
#include <cstddef>

#include "lib/base/number_text.h"
#include "postproc/cldata/interpreter.h"
#include "postproc/cldata/text.h"

// Statements that are not understood: counted by word, and where they could have moved the tool, the moves
// they could have changed are not checked.

namespace gouge {
namespace {

// A word with this many numbers may be a motion, and with that many more a coordinate system.
constexpr std::ptrdiff_t kNumbersOfMotion = 3;
constexpr std::ptrdiff_t kNumbersOfFrame = 9;

// G0 to G3 and a number of an axis: "G00 Z-10.", "N10G1X5".
bool is_motion_of_control(std::string_view text) {
  bool has_motion = false, has_axis = false;
  for (std::size_t i = 0; i + 1 < text.size(); ++i) {
    const char c = static_cast<char>(std::toupper(static_cast<unsigned char>(text[i])));
    if (i > 0 && std::isalpha(static_cast<unsigned char>(text[i - 1])) != 0) continue;
    const std::string_view rest = trim(text.substr(i + 1));
    if (rest.empty()) break;
    const bool is_number = is_digit(rest[0]) || rest[0] == '-' || rest[0] == '+' || rest[0] == '.';
    has_axis = has_axis || (is_number && std::string_view("XYZUVWABC").find(c) != std::string_view::npos);
    if (c != 'G' || !is_digit(text[i + 1])) continue;
    const std::size_t end = std::min(text.find_first_not_of("0123456789", i + 1), text.size());
    has_motion = has_motion || parse_integer(text.substr(i + 1, end - i - 1)).value_or(4) <= 3;
  }
  return has_motion && has_axis;
}

std::string_view without_quotes(std::string_view text) {
  while (!text.empty() && text.front() == '\'') text.remove_prefix(1);
  while (!text.empty() && text.back() == '\'') text.remove_suffix(1);
  return text;
}

}  // namespace

// Text for the control may move the machine. SolidWorks CAM names its tools so.
void Interpreter::take_insert() {
  last_insert_ = name_text(statement_->pieces.front());
  if (dialect_.kind == DialectKind::solidworks_cam || !is_motion_of_control(statement_->pieces.front())) return;
  count_unknown();
  emit_unread();
}

// CAMplete: SYN/'TLAXIS','$$*TLAXIS' makes comments of TLAXIS. Other names of words would have to be read as these.
void Interpreter::take_syn() {
  for (const Argument& argument : arguments_) {
    if (equals_ignoring_case(argument.text, "'TLAXIS'")) {
      is_tlaxis_ignored_ = true;
    } else if (find_word(without_quotes(argument.text)) != Word::unknown) {
      return fail("path-statement", "SYN: a synonym of " + quoted_text(argument.text) +
                                        "; expected the words themselves: write them in place of their synonyms");
    }
  }
}

// Without numbers a word cannot say where the tool goes; words that switch something have one or two.
void Interpreter::take_unknown() {
  count_unknown();
  const auto numbers = std::count_if(arguments_.begin(), arguments_.end(),
                                     [](const Argument& argument) { return argument.number.has_value(); });
  if (numbers >= kNumbersOfFrame) {
    unread_frame_reason_ = because(Reasons::kUnreadFrame);
  } else if (numbers >= kNumbersOfMotion) {
    emit_unread();
  }
}

// A motion nobody knows the end of stands where the last one ended, so that it is told as a move not checked.
void Interpreter::emit_unread(const char* reason, std::size_t statement) {
  resolve_tool();
  resolve_operation();
  Move move;
  move.line = path_.statements[statement].line;
  move.statement = statement;
  if (last_pose_) {
    move.end = *last_pose_;
  } else if (!path_.moves.empty()) {
    move.end = path_.moves.back().end;
  }
  move.tool = tool_index_;
  move.operation = operation_index_;
  move.not_checked_reason = reason;
  if (move.not_checked_reason == Reasons::kUnread) {
    move.not_checked_reason = reasons_.name(reason, statement_->major);
  }
  if (records_ != nullptr) {
    Position position;
    position.form = PositionForm::unread;
    position.axis_local = implied_axis();
    records_->of_move.push_back(make_record(move, position));
  }
  break_motion();
  last_pose_ = move.end;
  unknown_start_ = Reasons::kAfterUnread;
  is_rapid_ = false;
  was_from_ = false;
  make_room(path_.moves);
  path_.moves.push_back(move);
}

}  // namespace gouge
