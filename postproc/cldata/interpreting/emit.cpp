#include "postproc/cldata/interpreting/emit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "lib/base/tolerance.h"
#include "postproc/cldata/interpreting/further_readings.h"

namespace gouge {
namespace {

MotionRecord make_record(States& s, const Move& move, const Position& position) {
  MotionRecord record;
  record.statement = move.statement;
  record.point = position.point;
  record.points = position.points;
  record.first_argument = position.first_argument;
  record.rapid_statement = s.feed.rapid_statement();
  record.block = s.blocks.number();
  if (move.kind == MoveKind::arc && s.curve.arc()) record.curve_statement = s.curve.statement();
  record.numbers = static_cast<std::uint8_t>(position.numbers);
  record.form = position.form;
  record.is_rapid = s.feed.is_rapid();
  record.cutcom = s.cutcom.side();
  record.is_tapping = position.form == PositionForm::cycle && s.cycle.drill() && s.cycle.drill()->is_tapping;
  record.is_multax_off = s.axes.needs_multax();
  record.axis_local = position.axis_local;
  record.implied_axis_local = s.axes.implied();
  record.frame = s.frame.record(s.records->frames);
  return record;
}

void record(States& s, const Move& move, const Position& position) {
  if (s.records != nullptr) s.records->of_move.push_back(make_record(s, move, position));
}

void push(States& s, const Move& move) {
  s.in.make_room(s.in.path.moves);
  s.in.path.moves.push_back(move);
}

// Returns the resolution of the numbers of a position, in mm; 0 if it has no numbers, or they are integers.
double rounding_mm(const States& s, const Position& position) {
  constexpr std::size_t kCoordinates = 3;
  const std::span<const Argument> all(s.in.arguments);
  if (position.numbers == 0 || position.first_argument + kCoordinates > all.size()) return 0;
  return rounding_of_points(all.subspan(position.first_argument, kCoordinates)) * s.frame.mm_per_unit();
}

double rise_mm(const States& s, const Vec3& axis, const Move& move) {
  return std::abs((move.end.tip - s.chain.last_pose()->tip).dot(axis));
}

// Returns whether the rise of an arc along its axis is that of its sweep, with a slope per turn.
bool rises_with_turns(const States& s, double slope_mm, const Move& move) {
  if (move.curve_kind != CurveKind::arc) return true;
  const PathArc& arc = s.in.path.arcs[move.curve];
  const double of_turns = std::abs(slope_mm * arc.sweep_rad) / (2 * std::numbers::pi);
  return std::abs(rise_mm(s, arc.axis, move) - of_turns) <= Tolerance::kFilePoint_mm;
}

void attach_curve(States& s, const Position& position, Move& move) {
  if (!move.has_start) {
    move.not_checked_reason = ArcProblems::kStart;
  } else if (s.curve.arc()) {
    ArcStatement arc = *s.curve.arc();
    arc.center = s.frame.to_part().point(arc.center);
    arc.axis = s.frame.to_part().direction(arc.axis);
    arc.rounding_mm = std::max(arc.rounding_mm, rounding_mm(s, position));
    const bool rises_otherwise = s.arc_slope_mm && !(std::abs(rise_mm(s, arc.axis, move) - std::abs(*s.arc_slope_mm)) <=
                                                     Tolerance::kFilePoint_mm);
    if (rises_otherwise && arc.sense == ArcSense::unknown && arc.problem.empty()) arc.problem = ArcProblems::kSlope;
    s.senses.attach(arc, position, *s.chain.last_pose(), s.cutcom.reason(), move);
    if (rises_otherwise && !rises_with_turns(s, *s.arc_slope_mm, move)) move.not_checked_reason = ArcProblems::kSlope;
  } else {
    s.nurbs.attach(*s.chain.last_pose(), move);
  }
}

// Returns whether positions are uncertain only because the control may skip them; otherwise they are certain.
bool is_skipped(const States& s) { return s.uncertainties.is_alone(Uncertainty::skip) && !s.skips_more_than_motion; }

// Emits a position under a cycle that should have ended: it is a hole or a position of a motion.
void emit_uncertain(States& s, const Position& position) {
  mark_cycle_uncertain(s);
  Move move = make_move(s, position, MoveKind::cycle);
  if (s.uncertainties.reason() == nullptr) move.not_checked_reason = s.cycle.uncertainty_reason();
  append(s, move, position);
  s.chain.lose_start(Reasons::kAfterCycle);
}

// Notes the motion code of a position. Returns why it may run with the code of a text for the control, or null.
const char* note_motion_code(States& s, bool is_known, bool is_rapid) {
  if (!is_known) return s.control_motion.note(MotionCode::other);
  return s.control_motion.note(is_rapid ? MotionCode::rapid : MotionCode::straight);
}

// Returns the plane of an arc in the axes of the file; none: another curve, or another plane.
std::optional<ControlPlane> plane_of_arc(const States& s) {
  if (!s.curve.arc()) return std::nullopt;
  const Vec3 axis = s.curve.arc()->axis.normalized().cwiseAbs();
  const std::array<ControlPlane, 3> planes = {ControlPlane::yz, ControlPlane::zx, ControlPlane::xy};
  for (std::size_t k = 0; k < planes.size(); ++k) {
    if (axis[static_cast<int>(k)] > 1 - Tolerance::kExactDirection) return planes.at(k);
  }
  return std::nullopt;
}

}  // namespace

void resolve_tool(States& s) {
  const std::size_t before = s.tool.index();
  if (!s.tool.resolve()) return;
  if (before == kNone && s.chain.was_from()) {
    s.in.path.moves.back().tool = s.tool.index();  // FROM states the position of the first tool
  } else {
    const std::optional<ArcStatement> arc = s.curve.arc();
    break_motion(s);
    s.curve.restore(arc);
  }
  s.cycle.change_tool();
}

void emit(States& s, const Position& position) {
  s.setup.settle();
  resolve_tool(s);
  (void)s.operation.resolve();
  const bool is_from = position.form == PositionForm::from;
  if (s.cycle.is_doubtful()) return emit_uncertain(s, position);
  const bool is_cycle =
      s.cycle.is_on() && (position.form == PositionForm::go_to || position.form == PositionForm::godlta);
  if (is_cycle) s.control_motion.note(MotionCode::other);
  if (is_cycle && s.cycle.drill())
    if (const char* const reason = s.control_modes.note_cycle()) s.cycle.doubt(reason);
  if (is_cycle && s.cycle.drill() && s.uncertainties.reason() == nullptr)
    return emit_hole(s, position, *s.cycle.drill());

  const bool is_arc = !is_cycle && (s.curve.arc() || position.form == PositionForm::curve);
  const bool was_rapid_pending = s.feed.is_rapid_pending(), was_kind_doubtful = s.feed.is_kind_doubtful();
  const bool may_be_rapid = !is_cycle && !is_from && position.form != PositionForm::gohome && s.feed.may_be_rapid();
  if (s.feed.is_rapid() || may_be_rapid) s.feed.note_rapid_position();
  const bool is_rapid = s.feed.is_rapid() || is_from || position.form == PositionForm::gohome;
  if (!is_cycle) settle_retract(s, position);
  const bool is_kind_doubtful = was_kind_doubtful && !is_from && position.form != PositionForm::gohome;
  if (!is_cycle && !is_arc && !is_kind_doubtful) find_start_behind_skip(s, position);
  Move move = make_move(s, position,
                        is_cycle   ? MoveKind::cycle
                        : is_arc   ? MoveKind::arc
                        : is_rapid ? MoveKind::rapid
                                   : MoveKind::feed);
  if (may_be_rapid) move.set_feed({0, FeedUnit::rapid});  // so it must be clear of stock, and removes none
  const bool is_code_known = !may_be_rapid && !is_arc && !is_kind_doubtful;
  const char* const other_code = is_from || is_cycle ? nullptr : note_motion_code(s, is_code_known, is_rapid);
  if (move.not_checked_reason.empty() && other_code != nullptr) move.not_checked_reason = other_code;
  if (move.not_checked_reason.empty() && is_kind_doubtful) move.not_checked_reason = s.skip_reason;
  if (move.not_checked_reason.empty() && is_cycle) move.not_checked_reason = s.cycle.why();
  const char* const other_arc = is_arc ? s.control_modes.note_arc(plane_of_arc(s)) : nullptr;
  if (move.not_checked_reason.empty() && other_arc != nullptr) move.not_checked_reason = other_arc;
  if (move.not_checked_reason.empty() && is_arc) attach_curve(s, position, move);
  if (is_arc) s.arc_slope_mm.reset();
  const bool has_part_of_turn = move.not_checked_reason == ArcProblems::kTimes;
  append(s, move, position);
  if (is_from && was_rapid_pending) s.feed.keep_rapid_over_from();
  if (is_from && was_kind_doubtful) s.feed.doubt_kind();
  if (has_part_of_turn) emit_one_turn_more(s, position);
  emit_from_before_skip(s, position);
  emit_from_retract(s, position);
  emit_from_open_places(s, position);
  if (is_cycle) {
    s.chain.lose_start(Reasons::kAfterCycle);
    s.cycle.count_hole();
  }
  s.chain.note_from(is_from);
}

void push_move(States& s, const Move& move, const Position& position) {
  record(s, move, position);
  push(s, move);
}

Move make_move(States& s, const Position& position, MoveKind kind) {
  Move move;
  move.kind = kind;
  move.line = s.in.line();
  move.statement = s.in.index();
  move.end = s.frame.to_part().pose({position.tip_local, position.axis_local});
  move.end.axis.normalize();
  move.tool = s.tool.index();
  move.operation = s.operation.index();
  const bool is_at_rapid = kind == MoveKind::rapid || (kind != MoveKind::cycle && s.feed.is_rapid());
  move.set_feed(is_at_rapid ? Feed{0, FeedUnit::rapid} : s.feed.feed());
  move.spindle_rpm = s.feed.is_spindle_stopped() ? Move::kSpindleStopped : s.feed.spindle_rpm();
  move.has_start = s.chain.is_start_certain();
  const char* const uncertainty = is_skipped(s) ? nullptr : s.uncertainties.reason();
  for (const char* reason : {uncertainty, s.chain.last_uncertainty(), s.chain.unknown_start()}) {
    if (reason != nullptr && move.not_checked_reason.empty()) move.not_checked_reason = reason;
  }
  return move;
}

void append(States& s, Move move, const Position& position) {
  if (move.not_checked_reason.empty() && position.uncertainty != nullptr) {
    move.not_checked_reason = position.uncertainty;
    move.cover = position.cover;
  }
  if (move.not_checked_reason.empty() && is_skipped(s)) {
    move.not_checked_reason = s.uncertainties.reason();
    move.cover = Cover::motion;
  }
  if (move.not_checked_reason.empty() && s.movnrb.is_on) {
    move.not_checked_reason = Reasons::kMovnrb;
    move.cover = Cover::motion;
  }
  const std::string_view compensated = s.cutcom.reason();
  if (!compensated.empty() && (move.not_checked_reason.empty() || move.cover == Cover::motion)) {
    move.not_checked_reason = compensated;
    move.cover = s.cutcom.cover(move, s.chain.last_pose(), s.frame.to_part().rotation.col(2));
  }
  record(s, move, position);
  s.axes.note_position(position.axis_local);
  s.senses.note_motion(move, s.chain.last_pose());
  move.begins_stretch = s.chain.advance(move, is_skipped(s) ? nullptr : s.uncertainties.reason());
  s.cycle.leave_hole();
  s.cutcom.note_position();
  s.homed_axes = {};
  s.feed.end_rapid();
  push(s, move);
}

void emit_unread(States& s, const char* reason, std::size_t statement) {
  resolve_tool(s);
  const Moves& moves = s.in.path.moves;
  Move move;
  move.line = s.in.path.statements[statement].line;
  move.statement = statement;
  if (s.chain.last_pose()) {
    move.end = *s.chain.last_pose();
  } else if (!moves.empty()) {
    move.end = moves.back().end;
  }
  move.tool = s.tool.index();
  move.operation = s.operation.resolve();
  move.not_checked_reason = reason;
  if (move.not_checked_reason == Reasons::kUnread) {
    move.not_checked_reason = s.in.named(reason, s.in.statement().major);
  }
  Position position;
  position.form = PositionForm::unread;
  position.axis_local = s.axes.implied();
  record(s, move, position);
  break_motion(s);
  s.chain.forbid_link();
  s.curve.end_tangent();
  s.chain.stand(move.end, Reasons::kAfterUnread);
  s.homed_axes = {};
  s.feed.end_rapid();
  push(s, move);
}

void break_motion(States& s) {
  s.control_motion.note(MotionCode::other);
  find_start_for_link(s);
  s.chain.break_off();
  s.open_places.clear();
  s.retracted.reset();
  s.cycle.leave_hole();
  s.cutcom.break_motion();
  s.senses.break_motion();
  s.curve.end_arcs();
}

void mark_moves_uncertain(States& s, std::size_t begin, std::size_t end, std::string_view reason) {
  for (std::size_t i = begin; i < end; ++i) {
    std::string_view& own = s.in.path.moves[i].not_checked_reason;
    if (own.empty()) own = reason;
  }
  s.senses.uncertainty(begin, end, reason);
}

void switch_uncertainty(States& s, Uncertainty uncertainty, bool is_on, const char* reason) {
  const std::size_t run_begin = s.uncertainties.begin_run(uncertainty, s.in.moves());
  if (!is_on && !s.uncertainties.has(uncertainty) && s.uncertainties.was_on(uncertainty))
    mark_run_uncertain(s, run_begin);
  s.uncertainties.set(uncertainty, is_on ? s.in.because(reason) : nullptr);
}

void mark_run_uncertain(States& s, std::size_t begin) {
  begin = std::max(begin, s.run_begin);
  if (begin == s.in.moves()) return;
  mark_moves_uncertain(s, begin, s.in.moves(), s.in.because(Reasons::kStrayOff));
  s.chain.lose_last_pose(Reasons::kAfterUnread);
}

void mark_cycle_uncertain(States& s) {
  if (const auto moves = s.cycle.uncertainty())
    mark_moves_uncertain(s, moves->first, moves->second, s.cycle.uncertainty_reason());
}

void drop_described_curve(States& s) {
  const bool is_arc = s.curve.arc().has_value();
  s.curve.end_arc();
  s.curve.end_tangent();
  emit_unread(s, is_arc ? Reasons::kNoArcEnd : Reasons::kNoTlon, s.curve.statement());
}

void end_nurbs(States& s) {
  const std::size_t statement = s.nurbs.statement();
  const std::optional<Position> end = s.nurbs.end();
  if (!end) return;
  s.curve.end_arc();
  emit(s, *end);
  if (s.axes.is_modal_doubtful()) s.chain.lose_start(Reasons::kPlainAxis);
  s.in.path.moves.back().statement = statement;
  s.in.path.moves.back().line = s.nurbs.line();
  if (s.records != nullptr) s.records->of_move.back().statement = statement;
}

}  // namespace gouge
