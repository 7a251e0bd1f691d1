#include "postproc/cldata/interpreting/nurbs_state.h"

#include <cmath>
#include <string>
#include <utility>

#include "lib/base/tolerance.h"
#include "postproc/cldata/interpreting/reasons.h"

namespace gouge {
namespace {}  // namespace

void NurbsState::begin() {
  statement_ = in_.index();
  line_ = in_.line();
  knots_.clear();
  control_local_.clear();
  is_turning_ = false;
  // Degree 3 is what a NURBS without arguments has.
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

}  // namespace gouge
