#include "postproc/cldata/interpreting/emit.h"
#include "postproc/cldata/interpreting/word_handlers.h"

// Curves, which the positions behind them end.

namespace gouge {

// CIRCLE and MOVARC describe the arc to the next position; a list of positions runs on along it.
void take_arc(States& s) { s.curve.describe(read_arc(s.in.dialect, s.in.arguments, s.frame.mm_per_unit())); }

// With ON, until it is switched off.
void take_unread_curve(States& s) {
  const bool is_on = s.in.has("ON");
  if (is_on || s.in.has("OFF")) return switch_doubt(s, Doubt::spline, is_on, Reasons::kCurve);
  s.curve.describe(unreadable_arc(s.in.because(Reasons::kCurve)));
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
  position.doubt = is_doubtful ? Reasons::kPlainAxis : nullptr;
  emit(s, position);
  if (is_doubtful) s.chain.lose_start(Reasons::kPlainAxis);
  s.curve.end_arc();
}

}  // namespace gouge
