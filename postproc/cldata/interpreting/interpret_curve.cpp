#include <algorithm>
#include <cmath>
#include <string>

#include "postproc/cldata/interpreting/interpreter.h"
#include "postproc/cldata/language/text.h"
#include "postproc/cldata/parsing/arc_statement.h"

namespace gouge {
namespace {

constexpr const char* kPositionForm = "expected x,y,z or x,y,z,i,j,k";
constexpr double kShortest_mm = 1e-3;  // of a straight way whose direction tells anything
constexpr double kSmooth = 0.999;      // cosine between a line and an arc that go on in each other
constexpr double kSameAxis = 1e-9;     // sine of an angle
constexpr double kSamePoint_mm = 1e-3;
constexpr double kLeavesPlane_mm = 0.02;  // as far as start and end of an arc may differ in radius
constexpr double kTurningAxis = 1e-4;     // sine of an angle
constexpr std::size_t kClearVotes = 10;  // times as many as for the other sense
constexpr std::size_t kFewestVotes = 3;

ArcStatement unreadable(const char* problem) {
  ArcStatement arc;
  arc.problem = problem;
  return arc;
}

}  // namespace

// CIRCLE and MOVARC describe the arc to the next position; a list of positions runs on along it.
void Interpreter::take_arc() {
  arc_ = read_arc(dialect_, arguments_, mm_per_unit_);
  arc_statement_ = path_.statements.size() - 1;
}

void Interpreter::take_unread_curve() {
  const bool is_on = has_argument(arguments_, "ON"), is_off = !is_on && has_argument(arguments_, "OFF");
  if (is_off || is_on) {  // until it is switched off
    if (is_off && spline_reason_ == nullptr) doubt_run(Reasons::kStrayOff, spline_run_);
    spline_run_ = path_.moves.size();
    spline_reason_ = is_off ? nullptr : because(Reasons::kCurve);
    return;
  }
  arc_ = unreadable(because(Reasons::kCurve));
  arc_statement_ = path_.statements.size() - 1;
}

void Interpreter::take_indirv() {
  start_tangent_.reset();
  has_indirv_ = true;
  arc_statement_ = path_.statements.size() - 1;
  if (arguments_.size() != 3 || find_word_argument(arguments_) != nullptr) return;
  start_tangent_ = Vec3(*arguments_[0].number, *arguments_[1].number, *arguments_[2].number);
}

void Interpreter::take_tlon() {
  const std::optional<TlonStatement> tlon = read_tlon(arguments_, mm_per_unit_);
  if (!tlon && is_tlon_of_numbers(arguments_)) {
    count_unknown();
    return emit_unread();
  }
  if (!tlon) return refuse_part_program("TLON");
  Position position;
  position.form = PositionForm::curve;
  position.tip_local = tlon->end;
  const bool is_start_known = last_pose_ && unknown_start_ == nullptr;
  const Pose here = is_start_known ? to_part_.inverse().pose(*last_pose_) : Pose{};
  // The arc keeps the axis of the position before it.
  position.axis_local = is_start_known && multax_.value_or(false) ? here.axis : implied_axis();
  arc_ = is_start_known ? arc_of_tlon(*tlon, here.tip, start_tangent_) : unreadable(ArcProblems::kStart);
  start_tangent_.reset();
  has_indirv_ = false;
  const bool is_doubtful = !multax_.value_or(false) && has_doubtful_axis(position);
  doubt_ = is_doubtful ? Reasons::kPlainAxis : nullptr;
  emit(position);
  if (is_doubtful) unknown_start_ = Reasons::kPlainAxis;
  doubt_ = nullptr;
  arc_.reset();
}

void Interpreter::begin_curve() {
  curve_statement_ = path_.statements.size() - 1;
  curve_line_ = statement_->line;
  knots_.clear();
  control_local_.clear();
  // Degree 3 is what a NURBS without arguments has.
  is_curve_understood_ = arguments_.empty();
}

void Interpreter::take_knots() {
  if (curve_statement_ == kNone) {
    return fail("path-statement",
                "KNOT without a NURBS before it; expected NURBS/, KNOT/ and then CNTRL/ lines");
  }
  for (const Argument& argument : arguments_) {
    make_room(knots_);
    if (argument.number) knots_.push_back(*argument.number);
    is_curve_understood_ = is_curve_understood_ && argument.number.has_value();
  }
}

void Interpreter::take_control_point() {
  if (!check_all_numbers(kPositionForm)) return;
  const std::size_t count = arguments_.size();
  if (curve_statement_ == kNone) {
    return fail("path-statement",
                "CNTRL without a NURBS before it; expected NURBS/, KNOT/ and then CNTRL/ lines");
  }
  if (count != 3 && count != 6) {
    return fail("path-count", "CNTRL has " + std::to_string(count) + " numbers; " + kPositionForm);
  }
  const std::optional<Vec3> tip = read_tip(0);
  std::optional<Vec3> axis = implied_axis();
  if (count == 6) axis = read_axis(3);
  if (!tip || !axis) return;
  Position position;
  position.form = PositionForm::curve;
  position.tip_local = *tip;
  position.axis_local = *axis;
  make_room(control_local_);
  control_local_.push_back(*tip);
  curve_end_ = position;
}

void Interpreter::flush_curve() {
  if (!curve_end_) {
    curve_statement_ = kNone;
    return fail("path-statement", "the NURBS before this line has no CNTRL points; expected at least one");
  }
  const std::size_t statement = curve_statement_;
  arc_.reset();
  emit(*curve_end_);
  path_.moves.back().statement = statement;
  path_.moves.back().line = curve_line_;
  if (records_ != nullptr) records_->of_move.back().statement = statement;
  curve_end_.reset();
  curve_statement_ = kNone;
}

void Interpreter::attach_curve(const Position& position, Move& move) {
  if (!move.has_start) {
    move.not_checked_reason = ArcProblems::kStart;
  } else if (arc_) {
    attach_arc(position, move);
  } else {
    attach_spline(move);
  }
}

// The curve starts at the position before it, which its CNTRL lines do not repeat.
void Interpreter::attach_spline(Move& move) {
  move.not_checked_reason = Reasons::kSpline;
  const bool is_turning = last_pose_->axis.cross(move.end.axis).norm() > kSameAxis;
  if (!is_curve_understood_ || is_turning || knots_.empty() || std::abs(knots_.back() - 1) > 0) return;
  std::vector<Vec3> control;
  control.reserve(control_local_.size() + 1);
  control.push_back(last_pose_->tip);
  for (const Vec3& point : control_local_) control.push_back(to_part_.point(point));
  knots_.pop_back();
  PathSpline spline = make_spline(control, knots_);
  make_room(path_.splines);
  if (spline.pieces.empty()) return;
  move.not_checked_reason = {};
  move.curve_kind = CurveKind::spline;
  move.curve = path_.splines.size();
  path_.splines.push_back(std::move(spline));
}

void Interpreter::attach_arc(const Position& position, Move& move) {
  ArcStatement arc = *arc_;
  arc.center = to_part_.point(arc.center);
  arc.axis = to_part_.direction(arc.axis);
  if (dialect_.arc_rule == ArcRule::shorter_way && arc.problem.empty() && !is_round_in_nccs(position, arc, move)) return;
  if (dialect_.arc_rule == ArcRule::by_vector_or_against && arc.problem.empty()) doubt_autodesk_sense(arc, move);
  const bool is_open = arc.problem.empty() && arc.sense == ArcSense::unknown;
  if (arc.problem.empty() && last_direction_) vote(arc, last_pose_->tip, *last_direction_);
  if (is_open && is_reached_the_short_way(position)) arc.sense = shorter_way(arc, last_pose_->tip, move.end.tip);
  // In NCL the vector has no sense, so what other arcs tell of it says nothing of this one.
  if (arc.sense == ArcSense::unknown && arc.problem.empty() && dialect_.arc_rule != ArcRule::shorter_way) {
    make_room(open_arcs_);
    open_arcs_.push_back({path_.moves.size(), arc, cutcom_reason()});
  }
  fit(arc, last_pose_->tip, move);
}

// Newer posts of this dialect turn a clockwise arc's vector round; older ones leave it, so that its stated angle tells
// how it runs unless that is half a turn, or a whole one of a helix. Of a flat full circle both ways are the same.
void Interpreter::doubt_autodesk_sense(ArcStatement& arc, const Move& move) {
  constexpr double kOpposite = -0.999;
  const Vec3& start = last_pose_->tip;
  const Vec3& end = move.end.tip;
  if (fits_both_ways(arc, start, end)) {
    const bool is_flat_circle = (end - start).norm() <= 0 && last_pose_->axis.cross(move.end.axis).norm() <= kSameAxis;
    if (!is_flat_circle) arc.sense = ArcSense::unknown;
    return;
  }
  const bool is_right = fit_arc(arc, start, end).problem.empty();
  if (is_right && arc.axis.dot(last_pose_->axis) < kOpposite) ++turned_vectors_;
  arc.sense = ArcSense::left_handed;
  if (!is_right && fit_arc(arc, start, end).problem.empty()) ++wrong_way_arcs_;
  arc.sense = ArcSense::right_handed;
}

// A list may begin with the position the tool is at. An arc that leaves its plane or turns the tool is one to no
// reader for sure: NCL's own post-processor runs it straight.
bool Interpreter::is_round_in_nccs(const Position& position, const ArcStatement& arc, Move& move) const {
  const Vec3 way = move.end.tip - last_pose_->tip;
  const bool turns = last_pose_->axis.cross(move.end.axis).norm() > kTurningAxis;
  if (position.points > 1 && position.point == 0 && way.norm() <= kSamePoint_mm) return false;
  if (!turns && std::abs(way.dot(arc.axis)) <= kLeavesPlane_mm) return true;
  move.not_checked_reason = Reasons::kNccsArc;
  return false;
}

// Points that follow one another on a circle; and in NCL one alone, as its post-processor takes the sense from
// the way between two points, not from the vector.
bool Interpreter::is_reached_the_short_way(const Position& position) const {
  return position.points > 1 || dialect_.arc_rule == ArcRule::shorter_way;
}

ArcSense Interpreter::shorter_way(ArcStatement arc, const Vec3& start, const Vec3& end) {
  arc.sense = ArcSense::right_handed;
  const ArcFit right = fit_arc(arc, start, end);
  arc.sense = ArcSense::left_handed;
  const ArcFit left = fit_arc(arc, start, end);
  const double difference = std::abs(right.arc.sweep_rad) - std::abs(left.arc.sweep_rad);
  if (std::abs(difference) < 1) return ArcSense::unknown;
  return difference < 0 ? ArcSense::right_handed : ArcSense::left_handed;
}

void Interpreter::fit(const ArcStatement& arc, const Vec3& start, Move& move) {
  const ArcFit fit = fit_arc(arc, start, move.end.tip);
  if (fit.problem == ArcProblems::kRadius) {
    radius_errors_.add(move.line);
    worst_radius_error_mm_ = std::max(worst_radius_error_mm_, fit.radius_error_mm);
  }
  move.not_checked_reason = fit.problem;
  if (!fit.problem.empty()) return;
  move.curve_kind = CurveKind::arc;
  move.curve = path_.arcs.size();
  make_room(path_.arcs);
  path_.arcs.push_back(fit.arc);
}

// A line before or after an arc usually touches it, and so tells which way round the arc runs.
void Interpreter::vote(const ArcStatement& arc, const Vec3& tip, const Vec3& direction) {
  const double cosine = arc_tangent(arc, tip).dot(direction);
  if (std::abs(cosine) < kSmooth) return;
  ++(cosine > 0 ? right_votes_ : left_votes_);
  if (arc.sense == ArcSense::unknown) return;
  const bool is_as_read = (arc.sense == ArcSense::right_handed) == (cosine > 0);
  ++(is_as_read ? smooth_arcs_ : reversing_arcs_);
}

void Interpreter::note_direction(const Move& move) {
  last_direction_.reset();
  if (!move.has_start || move.kind == MoveKind::cycle || move.kind == MoveKind::arc) return;
  const Vec3 way = move.end.tip - last_pose_->tip;
  const double length = way.norm();
  if (!(length > kShortest_mm)) return;
  last_direction_ = way / length;
  if (!open_arcs_.empty() && open_arcs_.back().move + 1 == path_.moves.size()) {
    vote(open_arcs_.back().arc, last_pose_->tip, *last_direction_);
  }
}

// Arcs of a file whose dialect tells no sense: all of them have the one in which they go on smoothly.
void Interpreter::close_arcs() {
  if (open_arcs_.empty()) return;
  if (dialect_.arc_rule == ArcRule::by_vector_or_against) return close_autodesk_arcs();
  const bool is_right = right_votes_ >= kFewestVotes && right_votes_ >= kClearVotes * left_votes_;
  const bool is_left = left_votes_ >= kFewestVotes && left_votes_ >= kClearVotes * right_votes_;
  if (!is_right && !is_left) return;
  close_arcs_as(is_right ? ArcSense::right_handed : ArcSense::left_handed);
  const std::size_t votes = is_right ? right_votes_ : left_votes_;
  path_.notes.push_back(make_note(
      "path-arc-sense",
      "the dialect tells no sense for arcs; taken as " +
          std::string(is_right ? "right-handed (counter-clockwise)" : "left-handed (clockwise)") +
          " about their vector, as at " + std::to_string(votes) + " of " +
          std::to_string(right_votes_ + left_votes_) + " places where a line touches an arc it goes on smoothly",
      path_.file));
}

void Interpreter::close_arcs_as(ArcSense sense) {
  for (OpenArc& open : open_arcs_) {
    open.arc.sense = sense;
    Move& move = path_.moves[open.move];
    if (move.not_checked_reason != ArcProblems::kSense) continue;
    fit(open.arc, path_.start_of(open.move).tip, move);
    if (move.not_checked_reason.empty()) move.not_checked_reason = open.not_checked_reason;
  }
}

// One clockwise arc with its vector turned round, and none without, shows which posts wrote the file.
void Interpreter::close_autodesk_arcs() {
  if (turned_vectors_ == 0 || wrong_way_arcs_ > 0) return;
  close_arcs_as(ArcSense::right_handed);
}

}  // namespace gouge
