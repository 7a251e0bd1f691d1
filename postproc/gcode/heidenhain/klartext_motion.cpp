#include <cmath>
#include <numbers>
#include <utility>

#include "lib/base/tolerance.h"
#include "postproc/gcode/heidenhain/klartext_runner.h"

// Motions along lines, and the ends of all motions.

namespace gouge {
namespace {

using Meaning = KlartextMeaning;

constexpr double kSamePlace_mm = Tolerance::kSamePoint_mm;

}  // namespace

void KlartextRunner::begin_motion(const PathWords& words) {
  if (!has_preset_) choose_preset(std::nullopt);
  for (const KlartextFunction* row : words.functions) {
    if (row->meaning == Meaning::per_minute || row->meaning == Meaning::per_revolution)
      is_per_revolution_ = row->meaning == Meaning::per_revolution;
    if (row->meaning == Meaning::spindle_on) motion_.stop_spindle(false);
    if (row->meaning == Meaning::tip_control_on) begin_tip_control(why_point_open());
    if (row->meaning == Meaning::shortest_on) takes_shortest_ = true;
    if (row->meaning != Meaning::not_checked_path) continue;
    path_open_ = std::string(row->note) + ", by M" + std::to_string(row->number) + in_line(line_);
    settle_path();
  }
  if (words.compensation == PathCompensation::none) motion_.end_doubt(ProgramDoubt::compensation);
  if (words.compensation && *words.compensation != PathCompensation::none)
    motion_.doubt(ProgramDoubt::compensation, "radius compensation since line " + std::to_string(line_));
  take_feed(words);
}

void KlartextRunner::end_motion(const PathWords& words) {
  for (const KlartextFunction* row : words.functions) {
    if (row->meaning == Meaning::spindle_off) motion_.stop_spindle(true);
    if (row->meaning == Meaning::shortest_off) takes_shortest_ = false;
    if (row->meaning == Meaning::tip_control_off) end_tip_control();
    if (row->meaning == Meaning::retract) retract();
    if (row->meaning == Meaning::cycle_call) drill();
    if (row->meaning == Meaning::tool_change)
      run_unchecked(MoveKind::rapid, {}, "where the machine goes to change the tool is not known");
    if (row->meaning != Meaning::program_end) continue;
    has_ended_ = true;
    facts_.end_line = line_;
  }
}

void KlartextRunner::take_feed(const PathWords& words) {
  if (words.feed) feed_ = is_known(*words.feed) && *words.feed > 0 ? std::optional(*words.feed) : std::nullopt;
  set_feed();
}

// In a program in inches F is in tenths of an inch a minute on some versions: not understood.
void KlartextRunner::set_feed() {
  if (!feed_ || unit_ == LengthUnit::inch) return motion_.set_feed({0, FeedUnit::not_stated});
  motion_.set_feed({*feed_, is_per_revolution_ ? FeedUnit::per_revolution : FeedUnit::per_minute});
}

void KlartextRunner::retract() {
  Target to{motion_.place(), {}};
  to.place.xyz.setConstant(kUnknownValue);
  run_unchecked(MoveKind::feed, to, "M140 retracts the tool to a place that only the machine knows");
}

std::string KlartextRunner::why_corner_open() const {
  return is_cut_           ? "the next block rounds or chamfers the end of this motion"
         : follows_corner_ ? "the block before it rounds or chamfers the start of this motion"
                           : "";
}

void KlartextRunner::run_unchecked(MoveKind kind, const Target& to, const std::string& reason) {
  tangent_.reset();
  AxisPlace place = to.place;
  place.xyz = frame_.outside(place.xyz);
  motion_.go_unchecked(kind, place, reason);
  was_cut_ = is_cut_;
  follows_corner_ = false;
}

void KlartextRunner::run_line(MoveKind kind, const Target& to) {
  const std::string open = to.open.empty() ? why_corner_open() : to.open;
  if (!open.empty()) return run_unchecked(kind, to, open);
  const Vec3 step = to.place.xyz - place();
  const double along = step.head<2>().norm();
  AxisPlace end = to.place;
  end.xyz = frame_.outside(end.xyz);
  tangent_.reset();
  if (along > kSamePlace_mm && std::abs(step.z()) <= kSamePlace_mm)
    tangent_ = Direction{step.x() / along, step.y() / along};
  motion_.go(kind, end);
}

/// A line of a block: rapid with FMAX.
void KlartextRunner::run_block(const PathWords& words, const Target& to) {
  run_line(words.is_rapid ? MoveKind::rapid : MoveKind::feed, to);
}

// Takes a coordinate for the roundings of steps. Returns why its place is not known; empty: it is.
std::string KlartextRunner::round_step(std::size_t axis, const PathCoordinate& word, double unit,
                                       const std::string& name) {
  constexpr double kIncrement = 0.0001;  // mm, inches or degrees
  if (word.is_step)
    rounding_.add(axis, word.value * unit, kIncrement * unit);
  else
    rounding_.end(axis);
  return rounding_.why_open(axis, "I" + name);
}

KlartextRunner::Target KlartextRunner::target(const PathWords& words) {
  Target to{motion_.place(), {}};
  to.place.xyz = place();
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& word = words.xyz.at(i);
    if (!word) continue;
    double& own = to.place.xyz[static_cast<int>(i)];
    own = word->is_step ? own + length(word->value) : length(word->value);
    if (!is_known(word->value)) to.open = std::string("the value of ") + "XYZ"[i] + " is not known";
    if (!word->is_step) is_moved_.at(i) = false;
    if (const std::string drift = round_step(i, *word, length(1), std::string(1, "XYZ"[i])); !drift.empty()) {
      own = kUnknownValue;
      to.open = drift;
    }
    if (!is_moved_.at(i)) continue;
    own = kUnknownValue;
    to.open = std::string("I") + "XYZ"[i] + " is a step after a change of the frame; expected an absolute " + "XYZ"[i] +
              " before it";
  }
  activate_rotation(words, to);
  aim_rotary(words, to);
  if (words.function(Meaning::machine_place) != nullptr) aim_at_machine_place(words, to);
  if (words.function(Meaning::unknown_place) == nullptr) return to;
  to.place = AxisPlace{};
  to.open = "the block refers to a place that only the machine knows";
  return to;
}

// Source: cycle 10: it is active for both axes of the plane only after a motion of both.
void KlartextRunner::activate_rotation(const PathWords& words, Target& to) {
  const bool has_x = words.xyz[0].has_value(), has_y = words.xyz[1].has_value();
  if (rotation_line_ == 0 || (!has_x && !has_y)) return;
  if (!has_x || !has_y) {
    to.place.xyz.head<2>().setConstant(kUnknownValue);
    to.open = "CYCL DEF 10" + in_line(rotation_line_) +
              " is active after a motion of X and Y, and this block moves one of them";
    return;
  }
  rotation_line_ = 0;
}

void KlartextRunner::aim_rotary(const PathWords& words, Target& to) {
  if (!words.has_rotary()) return;
  if (is_tilt_open_) return align_with_plane(words, to);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& word = words.abc.at(i);
    if (!word) continue;
    const auto rotary = motion_.mapper().rotary_of("ABC"[i]);
    if (rotary) {
      aim_joint(*rotary, *word, words.function(Meaning::machine_place) != nullptr, to);
      continue;
    }
    if (!facts_.error) facts_.error = describe_missing_axis("ABC"[i], setup_.machine.get(), input_.path.file, line_);
  }
  if (words.function(Meaning::shortest_off) != nullptr && to.open.empty())
    to.open = "rotary axes turn in the block of M127, and no manual states when it acts";
  if (!has_tilt_) return;
  tilt_open_ = "rotary axes turn in a tilted plane" + in_line(line_);
  settle_frame();
}

// Source: machine parameter shortestDistance (300401): without M126 it decides on the way of half a turn and more.
void KlartextRunner::aim_joint(std::size_t rotary, const PathCoordinate& word, bool is_of_machine, Target& to) {
  constexpr double kHalf_rad = std::numbers::pi, kRounding_rad = 1e-8;
  double& angle = to.place.angles.at(rotary);
  const double before = angle;
  if (!is_known(word.value)) to.open = "the value of a rotary axis is not known";
  const std::string& name = setup_.machine->joints[setup_.machine->rotary.at(rotary)].name;
  if (const std::string drift = round_step(StepRounding::kFirstRotary + rotary, word, 1, name); !drift.empty())
    to.open = drift;
  if (word.is_step) {
    angle = before + word.value * kDegree_rad;
    return;
  }
  angle = is_of_machine ? word.value * kDegree_rad : motion_.angle_from_program(rotary, word.value);
  if (is_of_machine) motion_.note_angle_of_machine(rotary);
  const Joint& joint = setup_.machine->joints[setup_.machine->rotary.at(rotary)];
  const bool was_turn_open = std::exchange(is_turn_open_.at(rotary), false);
  const bool stands = std::abs(angle - before) <= kRounding_rad;
  if (was_turn_open && !takes_shortest_ && !stands)
    to.open = "M126 took " + joint.name + " beyond a turn, and no manual states whether the control counts it";
  const bool is_long = std::abs(angle - before) >= kHalf_rad - kRounding_rad;
  if (!is_long) return;
  if (takes_shortest_) {
    if (joint.is_continuous) angle -= kWholeTurn_rad * std::round((angle - before) / kWholeTurn_rad);
    is_turn_open_.at(rotary) = angle < -kRounding_rad || angle >= kWholeTurn_rad - kRounding_rad;
    const bool is_clear = joint.is_continuous && std::abs(angle - before) < kHalf_rad - kRounding_rad;
    if (!is_clear) to.open = "the way of " + joint.name + " by half a turn and more under M126 is not known";
  } else if (!setup_.winds_as_programmed.value_or(false)) {
    to.open =
        "a parameter of the control may shorten the turn of " + joint.name + "; expected --rotary-turns as-programmed";
  }
}

// After PLANE ... STAY the program itself brings the rotary axes to the angles that the control has calculated.
// Source: iTNC 530 60642x-04, PLANE, STAY: Q120, Q121 and Q122 of A, B and C.
void KlartextRunner::align_with_plane(const PathWords& words, Target& to) {
  static constexpr std::array<std::string_view, 3> kCalculated = {"Q120", "Q121", "Q122"};
  const bool has_machine = motion_.mapper().has_machine();
  std::size_t calculated = 0;
  bool is_clear = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& word = words.abc.at(i);
    const bool is_needed = has_machine && motion_.mapper().rotary_of("ABC"[i]);
    if (!word && is_needed) is_clear = false;
    if (!word) continue;
    is_clear = is_clear && !word->is_step && word->parameter == kCalculated.at(i);
    ++calculated;
  }
  constexpr std::size_t kRotaryAxes = 2;
  to.place.angles = {kUnknownValue, kUnknownValue};
  to.open = "the motion that aligns the tool with the tilted plane is not known";
  if (!is_clear || calculated < kRotaryAxes) {
    tilt_open_ = "line " + std::to_string(line_) +
                 " turns the rotary axes to other values than those that PLANE calculates: Q120, Q121 and Q122";
    return settle_frame();
  }
  motion_.align_to_plane();
  is_tilt_open_ = false;
}

// Source: iTNC 530 60642x-04, M91: coordinates from the machine datum; the length of the tool is not compensated.
void KlartextRunner::aim_at_machine_place(const PathWords& words, Target& to) {
  Vec3 machine = Vec3::Constant(kUnknownValue);
  bool has_step = false;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!words.xyz.at(i)) continue;
    machine[static_cast<int>(i)] = length(words.xyz.at(i)->value);
    has_step = has_step || words.xyz.at(i)->is_step;
  }
  if (has_step) machine.setConstant(kUnknownValue);
  const Vec3 stated = motion_.from_machine(machine);
  Vec3 outside = motion_.place().xyz;
  bool is_open = false;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!words.xyz.at(i)) continue;
    outside[static_cast<int>(i)] = stated[static_cast<int>(i)];
    is_open = is_open || std::isnan(stated[static_cast<int>(i)]);
  }
  to.place.xyz = frame_.inside(outside);
  if (has_step && to.open.empty()) to.open = "a place of the machine by M91 needs absolute values";
  if (is_open && to.open.empty())
    to.open =
        "the place of M91 in the coordinates of the part is not known; expected --offset of the preset in force, "
        "and the length of the tool; under M128 and in a tilted plane it is not read";
}

void KlartextRunner::go_line(const PathWords& words) {
  const bool has_coordinates = words.has_linear() || words.has_rotary();
  if (has_coordinates && words.function(Meaning::retract) != nullptr)
    return lose_rest("M140 beside coordinates is not read");
  begin_motion(words);
  polar_.reset();
  if (has_coordinates) run_block(words, target(words));
  end_motion(words);
}

KlartextRunner::Target KlartextRunner::polar_target(const PathWords& words) {
  Target to = target(words);
  const double unknown = kUnknownValue;
  double radius = polar_ ? polar_->radius : unknown, angle = polar_ ? polar_->angle : unknown;
  if (const auto& word = words.polar_radius) radius = length(word->value) + (word->is_step ? radius : 0);
  if (const auto& word = words.polar_angle) angle = word->value + (word->is_step ? angle : 0);
  std::string drift = words.polar_radius ? round_step(0, *words.polar_radius, length(1), "PR") : "";
  if (drift.empty() && words.polar_angle) drift = round_step(1, *words.polar_angle, 1, "PA");
  const std::array<double, 2> pole = pole_.value_or(std::array<double, 2>{unknown, unknown});
  to.place.xyz.x() = pole[0] + radius * std::cos(angle * kDegree_rad);
  to.place.xyz.y() = pole[1] + radius * std::sin(angle * kDegree_rad);
  if (!drift.empty()) {
    to.place.xyz.head<2>().setConstant(unknown);
    to.open = drift;
  }
  if (words.xyz[0] || words.xyz[1]) to.open = "a block states both X or Y and polar coordinates";
  if (words.function(Meaning::machine_place) != nullptr) to.open = "polar coordinates of a place of the machine";
  if (to.place.xyz.head<2>().hasNaN() && to.open.empty()) to.open = "the pole, the radius or the angle is not known";
  polar_ = Polar{radius, angle};
  is_moved_[0] = is_moved_[1] = false;
  return to;
}

void KlartextRunner::go_polar_line(const PathWords& words) {
  begin_motion(words);
  run_block(words, polar_target(words));
  end_motion(words);
}

// Rounding and chamfering change the motions on both sides of a corner, which are not checked.
void KlartextRunner::cut_corner(std::string_view text) {
  Words words;
  if (!read_words("R" + std::string(text), words)) return;
  if (!was_cut_) return lose_rest("RND or CHF without a motion right before it");
  follows_corner_ = true;
  tangent_.reset();
}

}  // namespace gouge
