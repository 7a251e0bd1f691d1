#include <algorithm>
#include <array>
#include <string>

#include "lib/base/letters.h"
#include "lib/base/tolerance.h"
#include "postproc/cldata/interpreting/emit.h"
#include "postproc/cldata/interpreting/frame_state.h"
#include "postproc/cldata/interpreting/misreading.h"
#include "postproc/cldata/interpreting/word_handlers.h"
#include "postproc/cldata/language/text.h"

// Handlers for positions and for the motion to them.

namespace gouge {
namespace {

bool is_axis_name(const Argument& argument) {
  constexpr std::array<std::string_view, 12> kNames = {"X",     "Y",     "Z",     "A",     "B",     "C",
                                                       "XAXIS", "YAXIS", "ZAXIS", "AAXIS", "BAXIS", "CAXIS"};
  return is_one_of(argument.text, kNames);
}

void take_positions(States& s, PositionForm form) {
  if (!s.in.check_all_numbers(kPositionForm)) return;
  const std::size_t numbers = s.axes.numbers_per_point();
  if (numbers == 0) return;
  if (const char* reason = s.axes.two_readings(numbers)) return emit_unread(s, reason);
  const auto [first, last] = s.axes.note_list(numbers);
  if (first < last) mark_moves_uncertain(s, first, last, Reasons::kSixNumbers);
  const std::size_t points = s.in.arguments.size() / numbers;
  const auto before = s.last_positions;
  s.last_positions = {s.in.index(),       numbers,
                      before.numbers,     s.in.arguments.back().text,
                      before.last_number, before.has_plain || before.numbers == 3};
  if (s.in.statement().is_continuation) s.curve.resume();
  if (s.curve.arc() && points > 1 && !s.in.dialect.lists_run_along_arc) s.curve.spoil(ArcProblems::kForm);
  bool is_going_on = false;
  s.in.make_room(s.in.path.moves, points);
  for (std::size_t i = 0; i < points; ++i) {
    Position position;
    position.first_argument = i * numbers;
    position.numbers = numbers;
    position.point = i;
    position.points = points;
    position.form = form;
    const std::optional<Vec3> tip = s.frame.read_tip(position.first_argument);
    const std::optional<Vec3> axis = numbers == 6 ? s.axes.read(position.first_argument + 3) : s.axes.implied();
    if (!tip || !axis) return;
    position.tip_local = *tip;
    position.axis_local = *axis;
    if (form == PositionForm::from) break_motion(s);
    const bool is_doubtful = s.axes.is_doubtful(position);
    const bool may_go_on = s.curve.may_go_on(position);
    position.uncertainty = is_doubtful ? Reasons::kPlainAxis : may_go_on ? Reasons::kNccsGoesOn : nullptr;
    is_going_on = is_going_on || may_go_on;
    emit(s, position);
    if (is_doubtful) s.chain.lose_start(Reasons::kPlainAxis);
  }
  if (!is_going_on) s.curve.end_statement();
}

// Takes the names of a GOHOME. Returns whether X, Y and Z are at home now. Before Z is there, an axis takes the tool past
// the part on a way that the file does not state; a rotary axis turns the part at the tool. With Z alone, the tool is at
// an unknown height above its last position.
bool brings_home(States& s) {
  CapitalSet homed = s.homed_axes;
  for (const Argument& argument : s.in.arguments) homed.add(capital(argument.text.front()));
  if (!homed.has('Z') && s.chain.last_pose()) emit_unread(s, s.in.because(Reasons::kHomeOfAxes));
  s.chain.lose_last_pose(Reasons::kAfterHomeOfAxes);
  s.homed_axes = homed;
  return homed.has('X') && homed.has('Y') && homed.has('Z');
}

// Returns whether the last move is a RETRCT to a plane above the position before it.
bool has_risen(const States& s) {
  const Moves& moves = s.in.path.moves;
  return s.retracted && moves.size() > 1 &&
         (moves[moves.size() - 2].end.tip - s.retracted->tip).norm() > Tolerance::kSamePoint_mm;
}

// Returns the start of a GODLTA. A step continues from the previous position. For a hole that is its own position,
// independent of the motion of the cycle, which the post-processor makes. After the last hole the tool is elsewhere,
// and files do not show from which of both positions a step continues. The same holds after RETRCT, which is a word of
// the post-processor: the step continues from the position before it, or from the plane.
std::optional<Pose> start_of_step(const States& s) {
  if (s.chain.last_uncertainty() != nullptr || s.cycle.is_doubtful()) return std::nullopt;
  const std::optional<Pose>& hole = s.cycle.last_hole();
  if (hole && s.cycle.is_on()) return hole;
  const bool is_elsewhere = hole && (hole->tip - s.chain.last_pose()->tip).norm() > Tolerance::kSamePoint_mm;
  if (s.chain.unknown_start() != nullptr || is_elsewhere || has_risen(s)) return std::nullopt;
  return s.chain.last_pose();
}

}  // namespace

void take_goto(States& s) { take_positions(s, PositionForm::go_to); }

void take_from(States& s) { take_positions(s, PositionForm::from); }

void take_godlta(States& s) {
  constexpr const char* kExpected = "expected dx,dy,dz, also with i,j,k, or one distance along the tool axis";
  if (!s.in.check_all_numbers(kExpected)) return;
  const std::size_t count = s.in.arguments.size();
  const bool has_axis = count == 6;
  if (count != 1 && count != 3 && !has_axis) {
    return s.in.fail("path-count", "GODLTA has " + std::to_string(count) + " numbers; " + kExpected);
  }
  if (!s.chain.last_pose()) {
    return s.in.fail("path-statement",
                     "GODLTA moves on from a position that is not known; expected a FROM or GOTO before it");
  }
  const std::optional<Pose> start = start_of_step(s);
  if (!start) return emit_unread(s, Reasons::kStepFromUnread);
  const Pose here = s.frame.to_local(*start);
  Position position;
  position.form = PositionForm::godlta;
  for (auto& [id, range] : s.indexed)
    if (range.begin == s.in.moves()) range.begins_with_step = true;
  position.axis_local = s.axes.is_new() ? s.axes.implied() : here.axis;
  if (has_axis) {
    const std::optional<Vec3> axis = s.axes.read(3);
    if (!axis) return;
    position.axis_local = *axis;
    position.numbers = 6;
    if (s.axes.is_doubtful(position)) position.uncertainty = Reasons::kPlainAxis;
    position.numbers = 0;
  }
  if (count == 1) {
    position.tip_local = here.tip + position.axis_local * (*s.in.arguments[0].number * s.frame.mm_per_unit());
  } else {
    const std::optional<Vec3> step = s.frame.read_tip(0);
    if (!step) return;
    position.tip_local = here.tip + *step;
  }
  emit(s, position);
  s.curve.end_arcs();
}

// Takes GOHOME. In GOHOME / Z the named axes go home at rapid. No file states the home position, so nothing leads to the
// next position.
void take_gohome(States& s) {
  const std::vector<Argument>& arguments = s.in.arguments;
  const bool names_axes = s.in.dialect.gohome_names_axes && std::ranges::all_of(arguments, is_axis_name);
  if (!arguments.empty() && !names_axes) return take_positions(s, PositionForm::gohome);
  s.feed.end_rapid();
  if (!arguments.empty() && !brings_home(s)) return;
  break_motion(s);
  s.chain.forbid_link();
}

// Takes CLEARP/XYPLAN,z or CLEARP/0,0,1,z. For any other form the plane is unknown.
void take_clear_plane(States& s) {
  take_harmless(s);
  const std::vector<Argument>& arguments = s.in.arguments;
  s.clear_plane_mm.reset();
  std::optional<double> height;
  if (arguments.size() == 2 && equals_ignoring_case(arguments[0].text, "XYPLAN")) height = arguments[1].number;
  if (s.in.has_numbers_alone(4) && (s.in.vector(0) - Vec3::UnitZ()).norm() <= kIdentityError)
    height = arguments[3].number;
  if (height) s.clear_plane_mm = *height * s.frame.mm_per_unit();
}

// Takes RETRCT: the tool moves up to the plane of CLEARP if it is known; else it is at an unknown height.
void take_retract(States& s) {
  s.control_motion.note(MotionCode::other);
  const bool is_known = s.in.arguments.empty() && s.clear_plane_mm && s.chain.is_start_certain() &&
                        s.uncertainties.reason() == nullptr && s.cutcom.reason().empty() && !s.cycle.is_on() &&
                        !s.cycle.is_doubtful() && !s.curve.is_open() && !s.feed.is_kind_doubtful();
  const Pose here = is_known ? s.frame.to_local(*s.chain.last_pose()) : Pose{};
  if (!is_known || here.axis.cross(Vec3::UnitZ()).norm() > Tolerance::kSameDirection || here.axis.z() < 0 ||
      here.tip.z() > *s.clear_plane_mm)
    return s.chain.lose_start(Reasons::kAfterRetract);
  Position position;
  position.form = PositionForm::unread;
  position.tip_local = {here.tip.x(), here.tip.y(), *s.clear_plane_mm};
  position.axis_local = here.axis;
  position.uncertainty = Reasons::kRetractPath;
  position.cover = Cover::motion;
  append(s, make_move(s, position, MoveKind::rapid), position);
  s.retracted = s.chain.last_pose();
}

// Takes RAPID. It has no numbers, so numbers in it may be a position.
void take_rapid(States& s) {
  if (count_numbers(s.in.arguments).count > 0) {
    s.in.count_unknown();
    emit_unread(s);
  } else if (!s.in.arguments.empty()) {
    // RAPID/XYPLAN, RAPID/MODIFY: the post-processor decides the order of the axes, so the next path is unknown.
    s.in.count_unknown();
    s.chain.lose_last_pose(Reasons::kAfterUnread);
  }
  s.feed.begin_rapid();
}

void take_fedrat(States& s) {
  distrust_numbers_of_feed(s);
  s.feed_units.note(s.in.arguments, s.in.line());
  s.feed.take_fedrat(s.frame.mm_per_unit());
}

// Takes CUTCOM. ADJUST concerns fixture registers; its OFF states nothing about LEFT and RIGHT.
void take_cutcom(States& s) {
  const bool has_side = s.in.has("LEFT") || s.in.has("RIGHT"), has_off = s.in.has("OFF");
  if (s.in.has("ADJUST")) {
    const bool is_off = s.in.arguments.size() == 2 && equals_ignoring_case(s.in.arguments.back().text, "OFF");
    switch_uncertainty(s, Uncertainty::adjust, !is_off, Reasons::kAdjust);
    if (has_side) s.cutcom.begin();
    return;
  }
  if (has_off && (has_side || s.in.has("ON"))) return s.cutcom.begin();
  // Compensation for the length of the tool acts along its axis, because positions are those of its tip.
  if (s.in.has("LENGTH") && !has_side) {
    const auto is_no_register = [](const Argument& argument) { return argument.number.value_or(0) < 0; };
    if (std::ranges::any_of(s.in.arguments, is_no_register))
      switch_uncertainty(s, Uncertainty::adjust, true, Reasons::kAdjust);
    // The register follows in CUTCOM/ON,LENGTH,n. OFF states none.
    if (!has_off && s.in.arguments.back().number) s.tool.take_length_register(*s.in.arguments.back().number);
    return;
  }
  if (!has_off) return s.cutcom.begin();
  const std::size_t run_begin = s.cutcom.begin_run();
  if (s.cutcom.end()) mark_run_uncertain(s, run_begin);
}

}  // namespace gouge
