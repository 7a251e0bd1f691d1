#include <cmath>

#include "postproc/cldata/cycle_statement.h"
#include "postproc/cldata/interpreter.h"
#include "postproc/cldata/text.h"

namespace gouge {
namespace {

constexpr double kSamePlace_mm = 1e-9;
constexpr double kSameAxis = 1e-9;  // sine of an angle

}  // namespace

void Interpreter::take_cycle() {
  if (arguments_.empty()) return count_unknown();
  const std::string_view what = arguments_.front().text;
  if (equals_ignoring_case(what, "INIT") || equals_ignoring_case(what, "CLEAR")) return;
  // Whether the control or the post-processor makes the moves.
  if (is_nccs(dialect_.kind) && equals_ignoring_case(what, "AUTO")) return;
  is_cycle_ = !equals_ignoring_case(what, "OFF") && !equals_ignoring_case(what, "NOMORE");
  if (equals_ignoring_case(what, "ON") || !is_cycle_) return;
  cycle_ = read_cycle(dialect_.kind, arguments_, mm_per_unit_);
  if (!cycle_) cycle_reason_ = because(Reasons::kCycle);
  if (cycle_ && !cycle_->is_retract_stated && cycles_without_retract_++ == 0) {
    first_cycle_without_retract_ = statement_->line;
  }
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
    emit_cycle_step(position, above(cycle.retract_mm), true);
  } else {
    emit_cycle_retract(position, above(cycle.retract_mm));
  }
  // A cycle that goes nowhere is a move all the same.
  if (path_.moves.size() == before) append(make_move(position, MoveKind::cycle), position);
  last_hole_ = to_part_.pose({position.tip_local, position.axis_local});
}

// To a plane nobody knows, past `tip_local`; the tool comes from there to the next position.
void Interpreter::emit_cycle_retract(const Position& position, const Vec3& tip_local) {
  Position step = position;
  step.tip_local = tip_local;
  step.form = PositionForm::cycle;
  Move move = make_move(step, MoveKind::cycle);
  move.feed_mm_per_min = 0;
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
  if (is_rapid) move.feed_mm_per_min = 0;
  append(move, step);
}

}  // namespace gouge
