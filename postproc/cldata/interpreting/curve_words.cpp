#include <algorithm>
#include <cmath>
#include <span>

#include "postproc/cldata/interpreting/emit.h"
#include "postproc/cldata/interpreting/word_handlers.h"
#include "postproc/cldata/language/text.h"

// Handlers for curves, each of which ends at a position after it.

namespace gouge {

// Takes CIRCLE and MOVARC, which describe the arc to the next position. A list of positions continues along the arc.
void take_arc(States& s) { s.curve.describe(read_arc(s.in.dialect, s.in.arguments, s.frame.mm_per_unit())); }

namespace {

// Emits an arc or a helix whose statement has its end, in the frame of positions.
void emit_curve_to(States& s, const ArcStatement& arc, const Vec3& tip_local) {
  Position position;
  position.form = PositionForm::curve;
  position.tip_local = tip_local;
  position.axis_local = s.frame.to_local(*s.chain.last_pose()).axis;
  s.curve.describe_whole(arc);
  emit(s, position);
  s.curve.end_arc();
}

bool are_numbers_alone(const StatementContext& in, std::size_t count) {
  return in.has_numbers_alone(count) && !has_damaged_argument(in.arguments);
}

}  // namespace

// Takes ARC/center,axis,radius,end of VERICUT. No document states its sense.
void take_arc_record(States& s) {
  constexpr std::size_t kNumbers = 10, kEnd = 7;
  if (!are_numbers_alone(s.in, kNumbers) || !s.chain.last_pose() || s.chain.unknown_start() != nullptr)
    return take_unread_motion(s);
  const std::optional<Vec3> end = s.frame.read_tip(kEnd);
  if (!end) return;
  Dialect dialect = dialect_of(DialectKind::apt);
  ArcStatement arc = read_arc(dialect, std::span<const Argument>(s.in.arguments).first(kEnd), s.frame.mm_per_unit());
  arc.sense = ArcSense::unknown;
  emit_curve_to(s, arc, *end);
}

// Takes ARCSLP/rise, which holds for the next arc. In any other form its numbers have no known meaning.
void take_arc_slope(States& s) {
  s.arc_slope_mm.reset();
  if (!s.in.has_numbers_alone(1)) {
    take_harmless(s);
    const auto is_rise = [](const Argument& a) { return a.number && std::abs(*a.number) > 0; };
    if (std::ranges::any_of(s.in.arguments, is_rise)) s.arc_slope_mm = kUnknownSlope;
    return;
  }
  s.arc_slope_mm = *s.in.arguments.front().number * s.frame.mm_per_unit();
}

// Takes HELICAL/center,axis,radius,rise,angle of CATIA, which has its own end. The end of a helix of whole turns is
// independent of its sense; any other helix is not read.
void take_helical(States& s) {
  constexpr std::size_t kNumbers = 9, kRadius = 6, kRise = 7, kAngle = 8;
  constexpr double kTurn_deg = 360, kWhole_deg = 1e-6, kMaxTurns = 1000;
  const bool is_start_known = s.chain.is_start_certain() && s.uncertainties.reason() == nullptr;
  const double turns = are_numbers_alone(s.in, kNumbers) ? std::abs(*s.in.arguments[kAngle].number) / kTurn_deg : 0;
  const bool is_whole =
      std::round(turns) >= 1 && turns <= kMaxTurns && std::abs(turns - std::round(turns)) <= kWhole_deg;
  if (!is_start_known || !is_whole) return take_unread_curve(s);
  ArcStatement arc = read_arc(dialect_of(DialectKind::apt),
                              std::span<const Argument>(s.in.arguments).first(kRadius + 1), s.frame.mm_per_unit());
  arc.sense = *s.in.arguments[kAngle].number > 0 ? ArcSense::right_handed : ArcSense::left_handed;
  arc.turns = static_cast<int>(std::round(turns));
  const double rise = *s.in.arguments[kRise].number * s.frame.mm_per_unit();
  emit_curve_to(s, arc, s.frame.to_local(*s.chain.last_pose()).tip + rise * arc.axis);
  emit_turned_round(s);
}

// Takes a curve that is not read. With ON it lasts until it is switched off.
void take_unread_curve(States& s) {
  const bool is_on = s.in.has("ON");
  if (is_on || s.in.has("OFF")) return switch_uncertainty(s, Uncertainty::spline, is_on, Reasons::kCurve);
  s.curve.describe(unreadable_arc(s.in.because(Reasons::kCurve)));
}

// Takes a curve in words of one control, whose lines of numbers begin no statement of CL data. Moves within it are not
// checked, nor are moves after a curve that never ends.
bool take_control_nurbs(States& s) {
  const Statement& statement = s.in.statement();
  if (statement.is_decoded || statement.pieces.empty()) return false;
  constexpr std::string_view kBegin = "BEGIN", kNurbs = "NURBS";
  // The equal signs in it keep the word and the text after it together.
  const bool is_whole = starts_with_ignoring_case(statement.major, kBegin) && statement.major.size() > kBegin.size();
  const std::string_view text = trim(is_whole ? statement.major.substr(kBegin.size()) : statement.pieces.front());
  const bool is_nurbs = starts_with_ignoring_case(text, kNurbs);
  if (is_nurbs && (is_whole || equals_ignoring_case(statement.major, kBegin))) {
    emit_unread(s, s.in.because(Reasons::kCurve));
    s.uncertainties.set(Uncertainty::control_curve, s.in.because(Reasons::kCurve));
    return true;
  }
  if (!s.uncertainties.has(Uncertainty::control_curve)) return false;
  if (is_nurbs && equals_ignoring_case(statement.major, "END")) {
    s.uncertainties.clear(Uncertainty::control_curve);
    s.chain.lose_last_pose(Reasons::kAfterUnread);
    return true;
  }
  return statement.word == Word::unknown;
}

void take_tlon(States& s) {
  const std::optional<TlonStatement> tlon =
      s.in.has("GOFWD") ? read_tlon(s.in.arguments, s.frame.mm_per_unit()) : std::nullopt;
  if (!s.in.has("GOFWD") || (!tlon && is_tlon_of_numbers(s.in.arguments))) {
    s.in.count_unknown();
    return emit_unread(s);
  }
  if (!tlon) return s.in.refuse_part_program("TLON");
  Position position;
  position.form = PositionForm::curve;
  position.tip_local = tlon->end;
  const bool is_start_known = s.chain.last_pose() && s.chain.unknown_start() == nullptr;
  const Pose here = is_start_known ? s.frame.to_local(*s.chain.last_pose()) : Pose{};
  // The arc keeps the axis of the position before it.
  position.axis_local = is_start_known && s.axes.is_multax_on() ? here.axis : s.axes.implied();
  s.curve.describe_end(is_start_known ? arc_of_tlon(*tlon, here.tip, s.curve.tangent())
                                      : unreadable_arc(ArcProblems::kStart));
  const bool is_doubtful = !s.axes.is_multax_on() && s.axes.is_doubtful(position);
  position.uncertainty = is_doubtful ? Reasons::kPlainAxis : nullptr;
  emit(s, position);
  const bool is_axis_lost = !is_start_known && s.axes.is_multax_on();
  if (is_doubtful || is_axis_lost) s.chain.lose_start(Reasons::kPlainAxis);
  s.curve.end_arc();
}

}  // namespace gouge
