#include "postproc/cldata/interpreting/nurbs_state.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lib/base/tolerance.h"
#include "postproc/cldata/interpreting/emit.h"
#include "postproc/cldata/interpreting/reasons.h"
#include "postproc/cldata/interpreting/word_handlers.h"
#include "postproc/cldata/language/text.h"

// Handlers for MOVNRB of Creo: a NURBS, and the positions on it.

namespace gouge {

void NurbsState::begin() {
  statement_ = in_.index();
  line_ = in_.line();
  knots_.clear();
  control_local_.clear();
  is_turning_ = false;
  // A NURBS without arguments has degree 3.
  is_understood_ = in_.arguments.empty();
}

void NurbsState::fail_without_begin(const char* word) {
  in_.fail("path-statement",
           std::string(word) + " without a NURBS before it; expected NURBS/, KNOT/ and then CNTRL/ lines");
}

void NurbsState::take_knots() {
  if (!is_open()) return fail_without_begin("KNOT");
  for (const Argument& argument : in_.arguments) {
    in_.make_room(knots_);
    if (argument.number) knots_.push_back(*argument.number);
    is_understood_ = is_understood_ && argument.number.has_value();
  }
}

void NurbsState::take_control_point() {
  if (!in_.check_all_numbers(kPositionForm)) return;
  const std::size_t count = in_.arguments.size();
  if (!is_open()) return fail_without_begin("CNTRL");
  if (count != 3 && count != 6) {
    return in_.fail("path-count", "CNTRL has " + std::to_string(count) + " numbers; " + kPositionForm);
  }
  const std::optional<Vec3> tip = frame_.read_tip(0);
  const std::optional<Vec3> axis = count == 6 ? axes_.read(3) : axes_.implied();
  if (!tip || !axis) return;
  Position position;
  position.form = PositionForm::curve;
  position.tip_local = *tip;
  position.axis_local = *axis;
  is_turning_ = is_turning_ || (end_ && end_->axis_local.cross(*axis).norm() > Tolerance::kSameDirection) ||
                (end_ && end_->axis_local.dot(*axis) < 0);
  in_.make_room(control_local_);
  control_local_.push_back(*tip);
  end_ = position;
  axes_.note_position(*axis);
}

std::optional<Position> NurbsState::end() {
  if (!end_) in_.fail("path-statement", "the NURBS before this line has no CNTRL points; expected at least one");
  statement_ = kNone;
  return std::exchange(end_, std::nullopt);
}

void NurbsState::attach(const Pose& start, Move& move) {
  move.not_checked_reason = Reasons::kSpline;
  const bool is_turning = is_turning_ || start.axis.cross(move.end.axis).norm() > Tolerance::kSameDirection;
  if (!is_understood_ || is_turning || knots_.empty() || std::abs(knots_.back() - 1) > 0) return;
  std::vector<Vec3> control;
  control.reserve(control_local_.size() + 1);
  control.push_back(start.tip);
  for (const Vec3& point : control_local_) control.push_back(frame_.to_part().point(point));
  knots_.pop_back();
  PathSpline spline = make_spline(control, knots_);
  in_.make_room(in_.path.splines);
  if (spline.pieces.empty()) return;
  move.not_checked_reason = {};
  move.curve_kind = CurveKind::spline;
  move.curve = in_.path.splines.size();
  in_.path.splines.push_back(std::move(spline));
}

namespace {

// Returns the inner knots, scaled to [0, 1], of a cubic whose first four knots are equal and whose last four are equal.
// Returns nothing for any other curve.
std::optional<std::vector<double>> inner_knots(const MovnrbState& curve) {
  constexpr std::size_t kOrder = 4;
  const std::vector<double>& knots = curve.knots;
  if (curve.order != kOrder || knots.size() != curve.control_local.size() + kOrder || knots.size() < 2 * kOrder)
    return std::nullopt;
  const double first = knots.front(), length = knots.back() - knots.front();
  if (!(length > Tolerance::kRounding)) return std::nullopt;
  for (std::size_t i = 0; i < kOrder; ++i) {
    if (knots[i] - first > Tolerance::kRounding || knots.back() - knots[knots.size() - 1 - i] > Tolerance::kRounding)
      return std::nullopt;
  }
  std::vector<double> inner;
  for (std::size_t i = kOrder; i + kOrder < knots.size(); ++i) inner.push_back((knots[i] - first) / length);
  return inner;
}

// Returns the curve as one move that begins at the current position.
std::optional<Move> curve_move(States& s) {
  const std::optional<std::vector<double>> inner = inner_knots(s.movnrb);
  if (!inner || s.movnrb.is_five_axis || !s.chain.is_start_certain() || s.uncertainties.reason() != nullptr ||
      !s.cutcom.reason().empty())
    return std::nullopt;
  std::vector<Vec3> control;
  for (const Vec3& point : s.movnrb.control_local) control.push_back(s.frame.to_part().point(point));
  const Pose start = *s.chain.last_pose();
  if ((control.front() - start.tip).norm() > Tolerance::kFilePoint_mm) return std::nullopt;
  control.front() = start.tip;
  PathSpline spline = make_spline(control, *inner);
  if (spline.pieces.empty()) return std::nullopt;
  Position position;
  position.tip_local = s.movnrb.control_local.back();
  position.axis_local = s.frame.to_local(start).axis;
  Move move = make_move(s, position, MoveKind::feed);
  move.curve_kind = CurveKind::spline;
  move.curve = s.in.path.splines.size();
  move.not_checked_reason = Reasons::kMovnrb;
  move.cover = Cover::motion;
  s.in.path.splines.push_back(std::move(spline));
  return move;
}

// Begins the positions of a curve. The control runs either the curve or the positions; both are checked.
void begin_positions(States& s) {
  const std::optional<Move> curve = curve_move(s);
  if (!curve) {
    s.uncertainties.set(Uncertainty::spline, s.in.because(Reasons::kSpline));
    return;
  }
  s.movnrb.begin = s.in.moves();
  s.movnrb.end = curve->end.tip;
  s.movnrb.is_on = true;
  emit_curve_reading(s, *curve);
}

void end_positions(States& s) {
  s.uncertainties.clear(Uncertainty::spline);
  if (!std::exchange(s.movnrb.is_on, false)) return;
  const bool is_end =
      s.chain.last_pose() && (s.chain.last_pose()->tip - s.movnrb.end).norm() <= Tolerance::kFilePoint_mm;
  for (std::size_t i = s.movnrb.begin; i < s.in.moves() && !is_end; ++i) s.in.path.moves[i].cover = Cover::none;
}

bool are_numbers(std::span<const Argument> arguments) {
  return std::ranges::all_of(arguments, [](const Argument& a) { return a.number.has_value(); });
}

}  // namespace

// Takes MOVNRB/ON,order,knots,weights,points,length; 1,knots; 2,points; NEXT before the positions; OFF after them.
void take_movnrb(States& s) {
  const std::vector<Argument>& arguments = s.in.arguments;
  const std::string_view what = arguments.empty() ? std::string_view() : arguments.front().text;
  const std::span<const Argument> rest = std::span<const Argument>(arguments).subspan(arguments.empty() ? 0 : 1);
  if (equals_ignoring_case(what, "M3AXIS")) {
    s.movnrb = {};
  } else if (equals_ignoring_case(what, "OFF")) {
    end_positions(s);
  } else if (equals_ignoring_case(what, "NEXT")) {
    begin_positions(s);
  } else if (equals_ignoring_case(what, "ON") && are_numbers(rest) && !rest.empty()) {
    const bool is_five_axis = s.movnrb.is_five_axis;
    s.movnrb = {};
    s.movnrb.is_five_axis = is_five_axis;
    s.movnrb.order = static_cast<std::size_t>(std::clamp(*rest.front().number, 0.0, 100.0));
  } else if (what == "1" && are_numbers(rest)) {
    for (const Argument& knot : rest) s.movnrb.knots.push_back(*knot.number);
  } else if (what == "2" && are_numbers(rest) && rest.size() % 3 == 0) {
    for (std::size_t i = 0; i < rest.size(); i += 3)
      s.movnrb.control_local.push_back(Vec3(*rest[i].number, *rest[i + 1].number, *rest[i + 2].number) *
                                       s.frame.mm_per_unit());
  } else {
    s.movnrb.is_five_axis = true;  // two curves, or an unknown word
  }
}

}  // namespace gouge
