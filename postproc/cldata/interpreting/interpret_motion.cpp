#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "lib/base/number_text.h"
#include "postproc/cldata/interpreting/interpreter.h"
#include "postproc/cldata/language/text.h"
#include "postproc/cldata/parsing/feed_statement.h"

namespace gouge {
namespace {

constexpr double kAxisLengthError = 1e-3;  // beyond it an axis is refused
constexpr double kAxisLengthTold = 1e-5;   // 5 decimals are what axes have; below it nothing is told
constexpr double kTiltTold = 1e-3;         // sine of the angle to +Z from which an axis counts as tilted
constexpr double kFarthest_mm = 1e7;       // ten kilometres: no machine is that large
constexpr const char* kPositionForm = "expected x,y,z or x,y,z,i,j,k";

double length_error(const Vec3& axis) {
  return std::abs(axis.norm() - 1);
}

bool begins_with_letter(std::string_view text) {
  return !text.empty() && ((text[0] >= 'A' && text[0] <= 'Z') || (text[0] >= 'a' && text[0] <= 'z'));
}

bool is_number_word(std::string_view text) {
  return starts_with_ignoring_case(text, "nan") || starts_with_ignoring_case(text, "inf");
}

}  // namespace

bool Interpreter::check_all_numbers(std::string_view expected) {
  const Argument* word = find_word_argument(arguments_);
  if (word == nullptr) return true;
  if (begins_with_letter(word->text) && !is_number_word(word->text) && path_.moves.empty()) {
    refuse_part_program(std::string(statement_->major) + "/" + std::string(word->text));
    return false;
  }
  const std::string what = word->text.empty() ? "an empty argument" : quoted_text(word->text);
  fail("path-number", std::string(statement_->major) + ": " + what + " is not a finite number; " +
                          std::string(expected) + " in numbers");
  return false;
}

// How many numbers of the statement make a position: 3 or 6, or 0 after an error.
std::size_t Interpreter::numbers_per_point() {
  const std::size_t count = arguments_.size();
  if (count == 3) return 3;
  if (statement_->has_axes) return 6;
  const auto axes_are_unit = [&] {
    for (std::size_t i = 3; i < count; i += 6) {
      const Vec3 axis(*arguments_[i].number, *arguments_[i + 1].number, *arguments_[i + 2].number);
      if (length_error(axis) > kAxisLengthError) return false;
    }
    return true;
  };
  const bool is_list = statement_->word == Word::go_to && !dialect_.is_axis_modal;
  if (count == 6 || (is_list && count > 6 && count % 6 == 0)) {
    if (!is_list || multax_.value_or(false)) return 6;
    if (dialect_.has_points_at_multax_off && multax_ == false) return 3;
    if (axes_are_unit()) return 6;
    // Two positions and a wrong axis look alike; only where MULTAX/OFF or the dialect tells is it two
    // positions.
    if (multax_.has_value() || dialect_.has_points_without_axis || count > 6) return 3;
    return 6;
  }
  if (is_list && !multax_.value_or(false) && count > 6 && count % 3 == 0) return 3;
  fail("path-count",
       std::string(statement_->major) + " has " + std::to_string(count) + " numbers; " + kPositionForm);
  return 0;
}

std::optional<Vec3> Interpreter::read_tip(std::size_t first) {
  const Vec3 tip =
      Vec3(*arguments_[first].number, *arguments_[first + 1].number, *arguments_[first + 2].number) *
      mm_per_unit_;
  if (tip.cwiseAbs().maxCoeff() <= kFarthest_mm) return tip;
  fail("path-range", std::string(statement_->major) + ": a coordinate is beyond " +
                         fixed_text(kFarthest_mm, 0) + " mm; expected a position within a machine");
  return std::nullopt;
}

std::optional<Vec3> Interpreter::read_axis(std::size_t first) {
  const Vec3 axis(*arguments_[first].number, *arguments_[first + 1].number, *arguments_[first + 2].number);
  const double length = axis.norm();
  const double error = std::abs(length - 1);
  if (!(error <= kAxisLengthError)) {
    fail("path-axis", std::string(statement_->major) + ": the tool axis has length " + fixed_text(length, 6) +
                          "; expected a unit vector i,j,k (length 1 within 0.001)");
    return std::nullopt;
  }
  if (error > kAxisLengthTold) {
    ++renormalised_;
    if (error > std::abs(worst_axis_length_ - 1)) worst_axis_length_ = length;
  }
  return axis / length;
}

// Two positions, the second of which happens to lie at a distance of 1 from the origin, look like a position and
// its axis. Where MULTAX/OFF says so, or a writer known to state MULTAX has not, nobody can tell.
bool Interpreter::are_axes_doubtful(std::size_t numbers) const {
  return numbers == 6 && !statement_->has_axes && !dialect_.is_axis_modal && needs_multax();
}

// Before an axis can be written. Those who write Creo and NCCS files say MULTAX where they mean it.
bool Interpreter::needs_multax() const {
  return !multax_.value_or(!dialect_.states_multax);
}

Vec3 Interpreter::implied_axis() const {
  return dialect_.is_axis_modal ? modal_axis_ : fixed_axis_;
}

// A position without an axis after a tilted one: it may have that one's, or the fixed one.
bool Interpreter::has_doubtful_axis(const Position& position) {
  if (dialect_.is_axis_modal || multax_ == false) return false;
  const bool is_known = dialect_.has_known_plain_axis && !(multax_ == true && dialect_.has_axes_under_multax);
  if (position.numbers == 6) {
    is_last_tilted_ = position.axis_local.cross(fixed_axis_).squaredNorm() > kTiltTold * kTiltTold;
  } else if (is_last_tilted_ && !is_known) {
    plain_after_tilt_.add(statement_->line);
    return true;
  }
  return false;
}

void Interpreter::take_positions(PositionForm form) {
  if (!check_all_numbers(kPositionForm)) return;
  const std::size_t numbers = numbers_per_point();
  if (numbers == 0) return;
  if (are_axes_doubtful(numbers)) return emit_unread(Reasons::kSixNumbers);
  const std::size_t points = arguments_.size() / numbers;
  if (statement_->is_continuation && !arc_) arc_ = last_arc_;
  if (arc_ && points > 1 && !dialect_.lists_run_along_arc) arc_->problem = ArcProblems::kForm;
  bool is_going_on = false;
  make_room(path_.moves, points);
  for (std::size_t i = 0; i < points; ++i) {
    Position position;
    position.first_argument = i * numbers;
    position.numbers = numbers;
    position.point = i;
    position.points = points;
    position.form = form;
    const std::optional<Vec3> tip = read_tip(position.first_argument);
    std::optional<Vec3> axis = implied_axis();
    if (numbers == 6) axis = read_axis(position.first_argument + 3);
    if (!tip || !axis) return;
    position.tip_local = *tip;
    position.axis_local = *axis;
    if (form == PositionForm::from) break_motion();
    const bool is_doubtful = has_doubtful_axis(position);
    const bool may_go_on = may_go_on_round(position);
    doubt_ = is_doubtful ? Reasons::kPlainAxis : may_go_on ? Reasons::kNccsGoesOn : nullptr;
    if (may_go_on) is_going_on = true;
    emit(position);
    if (is_doubtful) unknown_start_ = Reasons::kPlainAxis;
    doubt_ = nullptr;
  }
  if (!is_going_on) last_arc_ = std::exchange(arc_, std::nullopt);
}

// In NCL's text every position has a statement of its own; in its binary files those that follow a circle go on
// along it.
bool Interpreter::may_go_on_round(const Position& position) const {
  constexpr double kOnCircle_mm = 0.02;
  if (!dialect_.may_go_on_round || arc_ || !last_arc_ || !last_arc_->problem.empty()) return false;
  const Vec3 away = position.tip_local - last_arc_->center;
  const double radius = (away - away.dot(last_arc_->axis) * last_arc_->axis).norm();
  return std::abs(radius - last_arc_->radius_mm.value_or(radius)) <= kOnCircle_mm;
}

// A step goes on from the position before it. Of a hole that is its own, whatever the cycle's way up and down: a cycle
// is the post-processor's. After the last one the tool is elsewhere, and files do not tell which of both places counts.
std::optional<Pose> Interpreter::godlta_start() const {
  constexpr double kSamePlace_mm = 1e-9;
  if (last_frame_reason_ != nullptr) return std::nullopt;
  if (is_cycle_doubtful()) return std::nullopt;
  if (last_hole_ && cycle_.is_on) return last_hole_;
  const bool is_elsewhere = last_hole_ && (last_hole_->tip - last_pose_->tip).norm() > kSamePlace_mm;
  if (unknown_start_ != nullptr || is_elsewhere) return std::nullopt;
  return last_pose_;
}

void Interpreter::take_godlta() {
  if (!check_all_numbers("expected dx,dy,dz or one distance along the tool axis")) return;
  const std::size_t count = arguments_.size();
  if (count != 1 && count != 3) {
    return fail("path-count", "GODLTA has " + std::to_string(count) +
                                  " numbers; expected dx,dy,dz or one distance along the tool axis");
  }
  if (!last_pose_) {
    return fail("path-statement",
                "GODLTA moves on from a position that is not known; expected a FROM or GOTO before it");
  }
  const std::optional<Pose> start = godlta_start();
  if (!start) return emit_unread(Reasons::kStepFromUnread);
  const Pose here = to_part_.inverse().pose(*start);
  Position position;
  position.form = PositionForm::godlta;
  position.axis_local = is_tlaxis_new_ ? implied_axis() : here.axis;
  if (count == 1) {
    position.tip_local = here.tip + position.axis_local * (*arguments_[0].number * mm_per_unit_);
  } else {
    const std::optional<Vec3> step = read_tip(0);
    if (!step) return;
    position.tip_local = here.tip + *step;
  }
  emit(position);
  arc_.reset();
  last_arc_.reset();
}

void Interpreter::take_gohome() {
  if (!arguments_.empty() && !names_axes_only()) return take_positions(PositionForm::gohome);
  is_rapid_ = false;
  break_motion();
  can_link_ = false;
}

// It has no numbers: a position may stand here.
void Interpreter::take_rapid() {
  if (count_numbers(arguments_).count > 0) {
    count_unknown();
    emit_unread();
  } else if (!arguments_.empty()) {
    // RAPID/XYPLAN, RAPID/MODIFY: in which order the axes move is the post-processor's, so the next way is not known.
    count_unknown();
    if (last_pose_) unknown_start_ = Reasons::kAfterUnread;
  }
  is_rapid_ = true;
  rapid_statement_ = path_.statements.size() - 1;
}

// One without a unit after one per revolution: of which kind it is no file says.
void Interpreter::take_fedrat() {
  distrust_numbers_of_feed();
  if (switches_inverse_time(arguments_)) return;
  feed_ = read_feed(arguments_, mm_per_unit_);
  if (has_feed_per_turn_ && !has_feed_unit(arguments_)) feed_ = {0, FeedUnit::not_understood};
  has_feed_per_turn_ = has_feed_per_turn_ || feed_.unit == FeedUnit::per_revolution;
}

void Interpreter::take_multax() {
  const bool is_off = has_argument(arguments_, "OFF");
  const bool is_known = arguments_.empty() || (arguments_.size() == 1 && (is_off || has_argument(arguments_, "ON")));
  multax_reason_ = is_known ? nullptr : because(Reasons::kMultax);
  if (!is_known) count_unknown();
  multax_ = !is_off;
  is_last_tilted_ = is_last_tilted_ && *multax_;
}

void Interpreter::break_motion() {
  is_broken_ = is_broken_ || last_pose_.has_value();
  remember_link();
  last_pose_.reset();
  last_hole_.reset();
  unknown_start_ = nullptr;
  last_frame_reason_ = nullptr;
  was_compensated_ = false;
  last_direction_.reset();
  arc_.reset();
  last_arc_.reset();
}

// The machine does not go home between two positions only because a FROM, a CUTTER or another sequence stands there.
void Interpreter::remember_link() {
  if (!last_pose_) return;
  can_link_ = unknown_start_ == nullptr && last_frame_reason_ == nullptr && !path_.moves.empty();
}

// To a position alone, unless a tool may have been changed before it: another number, or a loading of another cutter.
void Interpreter::attach_link(Move& move) {
  const bool can_link = std::exchange(can_link_, false);
  const bool was_loaded = std::exchange(was_loaded_, false);
  if (!can_link || move.has_start || move.tool == kNone || path_.moves.back().tool == kNone) return;
  const std::size_t tool = path_.moves.back().tool;
  const std::optional<int> before = path_.tools[tool].number, now = path_.tools[move.tool].number;
  move.is_linked = move.tool == tool || (before && before == now && !was_loaded);
}

// ADJUST is about fixture registers; its OFF says nothing of LEFT and RIGHT. Those let the control offset the path by a
// radius nobody here knows, unless the file says that its positions are the cutter's centre.
void Interpreter::take_cutcom() {
  if (has_argument(arguments_, "ADJUST")) {
    const bool is_off = arguments_.size() == 2 && equals_ignoring_case(arguments_.back().text, "OFF");
    if (is_off && adjust_reason_ == nullptr) doubt_run(Reasons::kStrayOff, adjust_run_);
    adjust_run_ = path_.moves.size();
    adjust_reason_ = is_off ? nullptr : because(Reasons::kAdjust);
    if (has_argument(arguments_, "LEFT") || has_argument(arguments_, "RIGHT")) begin_cutcom();
    return;
  }
  const bool has_side = has_argument(arguments_, "LEFT") || has_argument(arguments_, "RIGHT");
  if (has_argument(arguments_, "OFF") && (has_side || has_argument(arguments_, "ON"))) return begin_cutcom();
  // Of the tool's length: along its axis, as positions are of its tip.
  if (has_argument(arguments_, "LENGTH") && !has_side) return;
  if (has_argument(arguments_, "OFF") && !has_side) return end_cutcom();
  begin_cutcom();
}

void Interpreter::begin_cutcom() {
  cutcoms_.add(statement_->line);
  cutcom_ = has_argument(arguments_, "LEFT")    ? CutcomSide::left
            : has_argument(arguments_, "RIGHT") ? CutcomSide::right
                                                : CutcomSide::unknown;
  was_ever_compensated_ = was_ever_compensated_ || is_compensated();
}

void Interpreter::end_cutcom() {
  if (cutcom_ == CutcomSide::none && !is_cutter_centre_) doubt_run(Reasons::kStrayOff, cutcom_run_);
  cutcom_run_ = path_.moves.size();
  cutcom_ = CutcomSide::none;
}

// The way of the program's positions is known all the same.
std::string_view Interpreter::cutcom_reason() const {
  if (is_compensated()) return Reasons::kCutcom;
  return was_compensated_ ? Reasons::kAfterCutcom : "";
}

void Interpreter::emit(const Position& position) {
  settle_setup();
  resolve_tool();
  resolve_operation();
  const bool is_from = position.form == PositionForm::from;
  if (is_cycle_doubtful() && !is_from) return emit_doubtful(position);
  const bool is_cycle =
      cycle_.is_on && (position.form == PositionForm::go_to || position.form == PositionForm::godlta);
  if (is_cycle && cycle_.drill && frame_reason() == nullptr) return emit_cycle(position, *cycle_.drill);

  const bool is_curve = position.form == PositionForm::curve;
  const bool is_arc = !is_cycle && (arc_ || is_curve);
  const bool is_rapid = is_rapid_ || is_from || position.form == PositionForm::gohome;
  Move move = make_move(position, is_cycle   ? MoveKind::cycle
                                  : is_arc   ? MoveKind::arc
                                  : is_rapid ? MoveKind::rapid
                                             : MoveKind::feed);
  if (move.not_checked_reason.empty() && is_cycle) move.not_checked_reason = cycle_reason_;
  if (move.not_checked_reason.empty() && is_arc) attach_curve(position, move);
  append(move, position);
  if (is_cycle) {
    unknown_start_ = Reasons::kAfterCycle;
    count_holes();
  }
  was_from_ = is_from;
}

Move Interpreter::make_move(const Position& position, MoveKind kind) {
  const char* frame = frame_reason();
  Move move;
  move.kind = kind;
  move.line = statement_->line;
  move.statement = path_.statements.size() - 1;
  move.end = to_part_.pose({position.tip_local, position.axis_local});
  move.end.axis.normalize();
  move.tool = tool_index_;
  move.operation = operation_index_;
  const bool is_at_rapid = kind == MoveKind::rapid || (kind == MoveKind::arc && is_rapid_);
  move.set_feed(is_at_rapid ? Feed{0, FeedUnit::rapid} : feed_);
  if (unknown_start_ == nullptr && last_frame_reason_ == nullptr) move.has_start = last_pose_.has_value();
  for (const char* reason : {frame, last_frame_reason_, unknown_start_}) {
    if (reason != nullptr && move.not_checked_reason.empty()) move.not_checked_reason = reason;
  }
  return move;
}

MotionRecord Interpreter::make_record(const Move& move, const Position& position) {
  if (!is_frame_recorded_) records_->frames.push_back({mm_per_unit_, to_part_});
  is_frame_recorded_ = true;
  MotionRecord record;
  record.statement = move.statement;
  record.point = position.point;
  record.points = position.points;
  record.first_argument = position.first_argument;
  record.rapid_statement = rapid_statement_;
  record.block = block_;
  if (move.kind == MoveKind::arc && arc_) record.curve_statement = arc_statement_;
  record.numbers = static_cast<std::uint8_t>(position.numbers);
  record.form = position.form;
  record.is_rapid = is_rapid_;
  record.cutcom = cutcom_;
  record.is_tapping = position.form == PositionForm::cycle && cycle_.drill && cycle_.drill->is_tapping;
  record.is_multax_off = needs_multax();
  record.axis_local = position.axis_local;
  record.implied_axis_local = implied_axis();
  record.frame = &records_->frames.back();
  return record;
}

void Interpreter::append(Move move, const Position& position) {
  if (move.not_checked_reason.empty() && doubt_ != nullptr) move.not_checked_reason = doubt_;
  if (move.not_checked_reason.empty()) move.not_checked_reason = cutcom_reason();
  if (records_ != nullptr) records_->of_move.push_back(make_record(move, position));
  if (is_broken_) not_swept_.add(move.line);
  attach_link(move);
  is_broken_ = false;
  if (dialect_.is_axis_modal) modal_axis_ = position.axis_local;
  note_direction(move);
  last_pose_ = move.end;
  last_hole_.reset();
  last_frame_reason_ = frame_reason();
  was_compensated_ = is_compensated();
  was_ever_compensated_ = was_ever_compensated_ || was_compensated_;
  is_tlaxis_new_ = false;
  unknown_start_ = nullptr;
  is_rapid_ = false;
  was_from_ = false;
  make_room(path_.moves);
  path_.moves.push_back(move);
}

}  // namespace gouge
