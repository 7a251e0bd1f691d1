#include <cmath>
#include <span>
#include <string_view>
#include <utility>

#include "postproc/cldata/interpreting/interpreter.h"
#include "postproc/cldata/language/text.h"
#include "postproc/cldata/parsing/cycle_statement.h"

namespace gouge {
namespace {

constexpr double kSamePlace_mm = 1e-9;
constexpr double kSameAxis = 1e-9;  // sine of an angle

}  // namespace

void Interpreter::take_cycle() {
  if (arguments_.empty()) {
    count_unknown();
    return distrust(Word::cycle);
  }
  const std::string_view what = arguments_.front().text;
  if (equals_ignoring_case(what, "INIT") || equals_ignoring_case(what, "CLEAR")) {
    if (cycle_.is_on) contradict(ModalState::cycle);  // does it end the one in force? no document says
    return;
  }
  // Whether the control or the post-processor makes the moves.
  if (dialect_.cycle_form == CycleForm::ncl && equals_ignoring_case(what, "AUTO")) return;
  const bool is_end = equals_ignoring_case(what, "OFF") || equals_ignoring_case(what, "NOMORE");
  if (is_end && arguments_.size() == 1) return end_cycle();
  begin_cycle();
}

// ON takes up the cycle that was switched off, in NX with other values for some of its words; CAMWorks CLT describes
// it in the statement after it, or behind it in the same one.
void Interpreter::begin_cycle() {
  if (has_argument(std::span(arguments_).subspan(0, 1), "ON") && arguments_.size() > 1) {
    if (dialect_.cycle_form == CycleForm::nx) take_changed_cycle();
    if (equals_ignoring_case(arguments_[1].text, "CYCLE")) arguments_.erase(arguments_.begin(), arguments_.begin() + 2);
  }
  if (arguments_.empty()) return count_unknown();
  const bool is_taken_up = equals_ignoring_case(arguments_.front().text, "ON");
  const bool describes = !is_taken_up || arguments_.size() > 1;
  const bool was_on = std::exchange(cycle_.is_on, true);
  if (is_taken_up && !describes && was_on && dialect_.cycle_form != CycleForm::clt) return;
  cycle_.line = statement_->line;
  cycle_.first_positions = kNone;
  cycle_.certain_moves = path_.moves.size();
  cycle_.is_contradicted = false;
  cycle_.reason = {};
  if (is_taken_up && (describes || dialect_.cycle_form == CycleForm::clt)) cycle_.drill.reset();
  if (is_taken_up) {
    if (!cycle_.drill) cycle_reason_ = describes ? because(Reasons::kCycle) : Reasons::kCycle;
    return;
  }
  cycle_.drill = read_cycle(dialect_.cycle_form, arguments_, mm_per_unit_);
  cycle_words_ = arguments_;
  if (!cycle_.drill) cycle_reason_ = because(Reasons::kCycle);
  if (cycle_.drill && !cycle_.drill->is_retract_stated) cycles_without_retract_.add(statement_->line);
}

// The arguments become those of the last cycle with the values that stand here; they stay as they are, and are then not
// understood, where there is none, or words stand here that have no value.
void Interpreter::take_changed_cycle() {
  if (cycle_words_.empty()) return;
  const std::optional<std::vector<Argument>> changed =
      changed_cycle(cycle_words_, std::span<const Argument>(arguments_).subspan(1));
  if (changed) arguments_ = *changed;
}

void Interpreter::end_cycle() {
  if (!std::exchange(cycle_.is_on, false)) doubt_moves_before_stray_end();
  cycle_.first_possible_hole = path_.moves.size();
}

// The end of a cycle that was lost may have stood behind any of its positions but the first.
void Interpreter::count_holes() {
  const std::size_t statement = path_.statements.size() - 1;
  const bool goes_on = statement_->is_continuation && cycle_.first_positions + 1 == statement;  // a list in records
  if (cycle_.first_positions == kNone || goes_on) cycle_.first_positions = statement;
  if (cycle_.first_positions == statement) cycle_.certain_moves = path_.moves.size();
}

void Interpreter::doubt_cycle() {
  if (!cycle_.reason.empty()) return;
  cycle_.reason = reasons_.name(Reasons::kCycleOpen, "CYCLE", cycle_.line);
  cycles_never_ended_.add(cycle_.line);
  const std::size_t end = cycle_.is_contradicted ? cycle_.contradicted_moves : path_.moves.size();
  doubt_moves(cycle_.certain_moves, end, cycle_.reason);
}

// CYCLE/OFF where no cycle is in force: one may have begun anywhere behind the last word that no cycle has.
void Interpreter::doubt_moves_before_stray_end() {
  std::string_view reason;
  for (std::size_t i = cycle_.first_possible_hole; i < path_.moves.size(); ++i) {
    Move& move = path_.moves[i];
    if (move.kind != MoveKind::feed || !move.not_checked_reason.empty()) continue;
    if (reason.empty()) {
      reason = because(Reasons::kCycleStrayEnd);
      cycles_never_begun_.add(statement_->line);
    }
    move.not_checked_reason = reason;
  }
  if (!reason.empty() && last_pose_) unknown_start_ = Reasons::kAfterCycle;
}

// Under a cycle that should have ended: a hole or a position of a motion.
void Interpreter::emit_doubtful(const Position& position) {
  doubt_cycle();
  Move move = make_move(position, MoveKind::cycle);
  if (frame_reason() == nullptr) move.not_checked_reason = cycle_.reason;
  append(move, position);
  unknown_start_ = Reasons::kAfterCycle;
}

// To a place above the next position before going down to it: at the height the tool has, or first up to the
// clearance where that is higher. A tool that must turn goes there straight, turning.
void Interpreter::emit_cycle(const Position& position, const DrillCycle& cycle) {
  const Vec3& axis = position.axis_local;
  const std::size_t before = path_.moves.size();
  const auto above = [&](double height_mm) { return Vec3(position.tip_local + height_mm * axis); };
  if (last_pose_ && unknown_start_ == nullptr && last_frame_reason_ == nullptr) {
    const Pose here = to_part_.inverse().pose(*last_pose_);
    const double height = (here.tip - position.tip_local).dot(axis);
    if (here.axis.cross(axis).norm() > kSameAxis) {
      emit_cycle_step(position, above(cycle.retract_mm), true);
    } else if (height < cycle.clearance_mm) {
      emit_cycle_step(position, here.tip + (cycle.clearance_mm - height) * axis, true);
    } else {
      emit_cycle_step(position, above(height), true);
    }
  }
  emit_cycle_step(position, above(cycle.clearance_mm), true);
  emit_cycle_step(position, above(cycle.bottom_mm), false);
  if (cycle.is_retract_known) {
    emit_cycle_step(position, above(cycle.retract_mm), !cycle.is_fed_out);
  } else {
    emit_cycle_retract(position, above(cycle.retract_mm));
  }
  // A cycle that goes nowhere is a move all the same.
  if (path_.moves.size() == before) append(make_move(position, MoveKind::cycle), position);
  last_hole_ = to_part_.pose({position.tip_local, position.axis_local});
  count_holes();
}

// To a plane nobody knows, past `tip_local`; the tool comes from there to the next position.
void Interpreter::emit_cycle_retract(const Position& position, const Vec3& tip_local) {
  Position step = position;
  step.tip_local = tip_local;
  step.form = PositionForm::cycle;
  Move move = make_move(step, MoveKind::cycle);
  move.set_feed({0, FeedUnit::rapid});
  if (move.not_checked_reason.empty()) move.not_checked_reason = Reasons::kRetractPlane;
  append(move, step);
  unknown_start_ = Reasons::kAfterCycle;
}

void Interpreter::emit_cycle_step(const Position& position, const Vec3& tip_local, bool is_rapid) {
  Position step = position;
  step.tip_local = tip_local;
  step.form = PositionForm::cycle;
  Move move = make_move(step, MoveKind::cycle);
  const bool is_same_place = move.has_start && (last_pose_->tip - move.end.tip).norm() <= kSamePlace_mm &&
                             last_pose_->axis.cross(move.end.axis).norm() <= kSameAxis;
  if (is_same_place) return;
  if (is_rapid) move.set_feed({0, FeedUnit::rapid});
  if (!is_rapid && cycle_.drill->feed.unit != FeedUnit::not_stated) move.set_feed(cycle_.drill->feed);
  append(move, step);
}

}  // namespace gouge
