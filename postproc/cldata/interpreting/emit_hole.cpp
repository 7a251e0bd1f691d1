#include "postproc/cldata/interpreting/emit.h"

namespace gouge {
namespace {

constexpr double kSameHolePoint_mm = 1e-9;
constexpr double kSameHoleAxis = 1e-9;  // sine of an angle

Position step_to(const Position& position, const Vec3& tip_local) {
  Position step = position;
  step.tip_local = tip_local;
  step.form = PositionForm::cycle;
  return step;
}

// To a plane nobody knows, past `tip_local`; the tool comes from there to the next position.
void emit_retract(States& s, const Position& position, const Vec3& tip_local) {
  const Position step = step_to(position, tip_local);
  Move move = make_move(s, step, MoveKind::cycle);
  move.set_feed({0, FeedUnit::rapid});
  if (move.not_checked_reason.empty()) move.not_checked_reason = Reasons::kRetractPlane;
  append(s, move, step);
  s.chain.lose_start(Reasons::kAfterCycle);
}

void emit_step(States& s, const Position& position, const Vec3& tip_local, bool is_rapid) {
  const Position step = step_to(position, tip_local);
  Move move = make_move(s, step, MoveKind::cycle);
  const std::optional<Pose>& last = s.chain.last_pose();
  const bool is_same_point = move.has_start && (last->tip - move.end.tip).norm() <= kSameHolePoint_mm &&
                             last->axis.cross(move.end.axis).norm() <= kSameHoleAxis;
  if (is_same_point) return;
  if (is_rapid) move.set_feed({0, FeedUnit::rapid});
  const Feed& plunge = s.cycle.drill()->feed;
  if (!is_rapid && plunge.unit != FeedUnit::not_stated) move.set_feed(plunge);
  append(s, move, step);
}

}  // namespace

// To a height above the next position before going down to it: at the height the tool has, or first up to the
// clearance where that is higher. A tool that must turn goes there straight, turning.
void emit_hole(States& s, const Position& position, const DrillCycle& cycle) {
  const Vec3& axis = position.axis_local;
  const std::size_t before = s.in.moves();
  const auto above = [&](double height_mm) { return Vec3(position.tip_local + height_mm * axis); };
  if (s.chain.is_start_certain()) {
    const Pose here = s.frame.to_local(*s.chain.last_pose());
    const double height = (here.tip - position.tip_local).dot(axis);
    if (here.axis.cross(axis).norm() > kSameHoleAxis) {
      emit_step(s, position, above(cycle.retract_mm), true);
    } else if (height < cycle.clearance_mm) {
      emit_step(s, position, here.tip + (cycle.clearance_mm - height) * axis, true);
    } else {
      emit_step(s, position, above(height), true);
    }
  }
  emit_step(s, position, above(cycle.clearance_mm), true);
  emit_step(s, position, above(cycle.bottom_mm), false);
  if (cycle.is_retract_known) {
    emit_step(s, position, above(cycle.retract_mm), !cycle.is_fed_out);
  } else {
    emit_retract(s, position, above(cycle.retract_mm));
  }
  // A cycle that goes nowhere is a move all the same.
  if (s.in.moves() == before) append(s, make_move(s, position, MoveKind::cycle), position);
  s.cycle.note_hole(s.frame.to_part().pose({position.tip_local, position.axis_local}));
}

}  // namespace gouge
