#include "postproc/cldata/interpreting/further_readings.h"

#include <array>
#include <numbers>
#include <utility>
#include <vector>

#include "lib/base/tolerance.h"
#include "postproc/cldata/interpreting/emit.h"

namespace gouge {
namespace {

// Adds the reading of the last move with another sweep.
void emit_other_sweep(States& s, const Position& position, double sweep_rad, Move move) {
  const Moves& moves = s.in.path.moves;
  PathArc arc = s.in.path.arcs[move.curve];
  arc.sweep_rad = sweep_rad;
  Move start = move;
  start.end = moves[moves.size() - 2].end;
  start.has_start = false;
  start.curve_kind = CurveKind::none;
  push_reading(s, position, start);
  move.curve = s.in.path.arcs.size();
  s.in.make_room(s.in.path.arcs);
  s.in.path.arcs.push_back(arc);
  push_reading(s, position, move);
}

}  // namespace

void open_last_move(States& s, const char* reason) {
  Move& last = s.in.path.moves.back();
  if (last.not_checked_reason.empty()) {
    last.not_checked_reason = reason;
    last.cover = Cover::motion;
  }
}

void push_reading(States& s, const Position& position, Move move) {
  Position reading = position;
  reading.form = PositionForm::unread;
  reading.numbers = 0;
  move.is_linked = false;
  move.begins_stretch = false;
  push_move(s, move, reading);
}

// Adds a reading of one more turn. The file does not state whether the part of a turn counts as one of TIMES.
void emit_one_turn_more(States& s, const Position& position) {
  constexpr double kTurn = 2 * std::numbers::pi;
  const Move& last = s.in.path.moves.back();
  if (last.curve_kind != CurveKind::arc || s.in.moves() < 2) return;
  const double sweep = s.in.path.arcs[last.curve].sweep_rad;
  emit_other_sweep(s, position, sweep + (sweep < 0 ? -kTurn : kTurn), last);
}

// Adds the readings from the plane of CLEARP: straight to the position, or first across to it.
void emit_from_retract(States& s, const Position& position) {
  const std::optional<Pose> plane = std::exchange(s.retracted, std::nullopt);
  if (!plane || !s.in.path.moves.back().has_start) return;
  Move& last = s.in.path.moves.back();
  const bool is_same_axis =
      plane->axis.cross(last.end.axis).norm() <= Tolerance::kSameDirection && plane->axis.dot(last.end.axis) > 0;
  if (!is_same_axis || last.curve_kind != CurveKind::none) {
    if (last.not_checked_reason.empty()) last.not_checked_reason = Reasons::kAfterRetract;
    return;
  }
  const double height = (plane->tip - last.end.tip).dot(plane->axis);
  const Pose across{last.end.tip + height * plane->axis, plane->axis}, end = last.end;
  const std::array<Pose, 2> ends = {across, end};
  emit_other_way(s, position, *plane, ends, Reasons::kAfterRetract);
}

// Adds straight readings from all places where the tool may be after a hole.
void emit_from_open_places(States& s, const Position& position) {
  const std::vector<Pose> places = std::exchange(s.open_places, {});
  if (places.empty() || !s.in.path.moves.back().has_start) return;
  Move& last = s.in.path.moves.back();
  const bool is_read = last.curve_kind == CurveKind::none && (last.not_checked_reason.empty() || last.is_covered());
  if (!is_read) {
    last.cover = Cover::none;
    if (last.not_checked_reason.empty()) last.not_checked_reason = Reasons::kHoleBounds;
    return;
  }
  const Pose end = last.end;
  for (const Pose& place : places) emit_other_way(s, position, place, {&end, 1}, Reasons::kHoleBounds);
}

// Settles RETURN,0 of CATIA. Its end, in any reading, is not above the next position straight above it. A plane of the
// setup (RTRCTO,AUTO of NX) may be higher.
void settle_retract(States& s, const Position& position) {
  if (s.in.dialect.cycle_form != CycleForm::catia) return;
  if (s.in.path.moves.empty() || !s.chain.last_pose() || s.chain.unknown_start() == nullptr) return;
  Move& last = s.in.path.moves.back();
  if (s.is_behind_skip || last.not_checked_reason != Reasons::kRetractPlane) return;
  const Pose here = s.frame.to_local(*s.chain.last_pose());
  const Vec3 way = position.tip_local - here.tip;
  const double height = way.dot(here.axis);
  if (height < 0 || (way - height * here.axis).norm() > Tolerance::kSamePoint_mm ||
      here.axis.cross(position.axis_local).norm() > Tolerance::kSameDirection)
    return;
  last.not_checked_reason = {};
  s.chain.find_start();
}

void emit_curve_reading(States& s, const Move& curve) {
  push_reading(s, {}, curve);
  Move start = curve;
  start.end = *s.chain.last_pose();
  start.has_start = false;
  start.curve_kind = CurveKind::none;
  push_reading(s, {}, start);
}

void emit_turned_round(States& s) {
  Move last = s.in.path.moves.back();
  if (last.curve_kind != CurveKind::arc || !last.not_checked_reason.empty() || s.in.moves() < 2) return;
  last.not_checked_reason = ArcProblems::kSense;
  last.cover = Cover::motion;
  emit_other_sweep(s, {}, -s.in.path.arcs[last.curve].sweep_rad, last);
}

void emit_other_way(States& s, const Position& position, const Pose& start, std::span<const Pose> ends,
                    const char* reason) {
  open_last_move(s, reason);
  Move move = s.in.path.moves.back();
  move.curve_kind = CurveKind::none;
  move.kind = MoveKind::rapid;
  move.set_feed({0, FeedUnit::rapid});
  move.end = start;
  move.has_start = false;
  push_reading(s, position, move);
  move.has_start = true;
  for (const Pose& end : ends) {
    move.end = end;
    push_reading(s, position, move);
  }
}

}  // namespace gouge
