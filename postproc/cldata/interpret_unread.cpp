#include <algorithm>
#include <cstddef>

#include "postproc/cldata/interpreter.h"

// Statements that are not understood: counted by word, and where they could have moved the tool, the moves
// they could have changed are not checked.

namespace gouge {
namespace {

// A word with this many numbers may be a motion, and with that many more a coordinate system.
constexpr std::ptrdiff_t kNumbersOfMotion = 3;
constexpr std::ptrdiff_t kNumbersOfFrame = 9;

}  // namespace

// Without numbers a word cannot say where the tool goes; words that switch something have one or two.
void Interpreter::take_unknown() {
  count_unknown();
  const auto numbers = std::count_if(arguments_.begin(), arguments_.end(),
                                     [](const Argument& argument) { return argument.number.has_value(); });
  if (numbers >= kNumbersOfFrame) {
    unread_frame_reason_ = Reasons::kUnreadFrame;
  } else if (numbers >= kNumbersOfMotion) {
    emit_unread();
  }
}

// A motion nobody knows the end of stands where the last one ended, so that it is told as a move not checked.
void Interpreter::emit_unread(const char* reason) {
  resolve_tool();
  resolve_operation();
  Move move;
  move.line = statement_->line;
  move.statement = path_.statements.size() - 1;
  if (last_pose_) {
    move.end = *last_pose_;
  } else if (!path_.moves.empty()) {
    move.end = path_.moves.back().end;
  }
  move.tool = tool_index_;
  move.operation = operation_index_;
  move.not_checked_reason = reason;
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
