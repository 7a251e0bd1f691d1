#include <algorithm>
#include <cmath>

#include "lib/base/number_text.h"
#include "postproc/gcode/siemens/siemens_runner.h"

// Motions of a block: their targets, and the places of the axes of the machine.

namespace gouge {
namespace {

using Meaning = SiemensMeaning;

constexpr double kTurn_deg = 360, kHalfTurn_deg = 180, kRounding_deg = 1e-6;

/// Returns whether an angle is one that a rotary axis with the range of one turn shows.
bool is_within_turn(double degrees) { return degrees >= 0 && degrees < kTurn_deg - kRounding_deg; }

}  // namespace

std::string SiemensRunner::missing_fact() const {
  if (!modes_.open_length.empty()) return modes_.open_length;
  if (!modes_.is_offset_stated) return "nothing states the work offset before this block; expected --start G54";
  return {};
}

void SiemensRunner::move() {
  if (const auto* const stated = words_.code_of(SiemensGroup::motion)) modes_.motion = stated->row;
  if (words_.code(Meaning::dwell) != nullptr) return;
  if (const auto* const code = words_.code(Meaning::leave_to_fixed_point))
    return motion_.go_unchecked(MoveKind::rapid, AxisPlace{},
                                code->word->name + " moves to a point that only the control knows");
  take_cycle();
  const auto* const frame = words_.code_of(SiemensGroup::frame);
  if (frame != nullptr) return;
  if (!words_.has_axes() && !words_.has_arc_words()) return;
  if (modes_.motion == nullptr)
    return lose_rest("axis words without G0, G1, G2 or G3 before them; expected --start G1", line_);
  const SiemensRow& row = *modes_.motion;
  const bool is_arc = row.meaning != Meaning::rapid && row.meaning != Meaning::line;
  const MoveKind kind = row.meaning == Meaning::rapid ? MoveKind::rapid : is_arc ? MoveKind::arc : MoveKind::feed;
  if (words_.has_arc_words() && !is_arc) return lose_rest("words of an arc without G2, G3 or CIP", line_);
  const auto* const suppressed = words_.code_of(SiemensGroup::suppression);
  if (suppressed != nullptr)
    move_to_machine_axes(kind, *suppressed);
  else
    move_to_target(kind);
  if (error_ || !modes_.modal_cycle) return;
  if (words_.has_path_axes() && !modes_.open_modal_cycle.empty())
    return lose_rest(modes_.open_modal_cycle + "; expected MCALL with the new value", line_);
  if (words_.has_path_axes()) return drill(*modes_.modal_cycle);
  motion_.go_unchecked(MoveKind::feed, AxisPlace{}, "MCALL is in force, and rotary axes alone move");
}

void SiemensRunner::move_to_target(MoveKind kind) {
  const Target to = target();
  if (error_) return;
  if (kind == MoveKind::arc) return go_round(*modes_.motion, to);
  go(kind, to);
}

void SiemensRunner::go(MoveKind kind, const Target& to) {
  if (to.open.empty())
    motion_.go(kind, to.place);
  else
    motion_.go_unchecked(kind, to.place, to.open);
}

SiemensRunner::Target SiemensRunner::target() {
  Target to{motion_.place(), {}};
  place_axes(to);
  place_rotaries(to);
  if (error_) return to;
  place_vector(to);
  const bool is_on = motion_.tip_control() == TipControl::on;
  if (is_on && !motion_.mapper().has_machine() && !to.place.axis && to.open.empty()) {
    to.open = "TRAORI without a direction of the tool; expected --machine, or A3, B3 and C3";
    to.place.xyz.setConstant(kUnknownValue);
  }
  const std::string missing = missing_fact();
  if (missing.empty()) return to;
  to.place.xyz.setConstant(kUnknownValue);
  to.open = missing;
  // A place of the part that is not known is no approach.
  if (words_.has_path_axes())
    motion_.doubt(modes_.open_length.empty() ? ProgramDoubt::offset : ProgramDoubt::length, missing);
  return to;
}

void SiemensRunner::place_axes(Target& to) {
  for (int i = 0; i < 3; ++i) {
    const SiemensWord* const word = words_.value(std::string_view("XYZ").substr(static_cast<std::size_t>(i), 1));
    if (word == nullptr) continue;
    const bool is_step = is_incremental(*word);
    const double stated = word->value * mm_per_unit();
    to.place.xyz[i] = is_step ? to.place.xyz[i] + stated : stated;
    const bool is_stated = word->measure == SiemensMeasure::absolute || is_step || modes_.is_absolute.has_value();
    const bool is_linear =
        word->measure == SiemensMeasure::modal || is_step || word->measure == SiemensMeasure::absolute;
    if (!is_stated) to.open = "nothing states G90 or G91 before this block; expected --start G90";
    if (!is_linear) to.open = word->name + " has a measure of a rotary axis";
    if (!is_known(word->value)) to.open = "the value of " + word->name + " is not known";
    if (is_step && modes_.is_moved[i] > 0)
      to.open = "a step of " + word->name +
                " after a change of frame or length: a setting of the control states whether it includes the change";
    if (!is_step) modes_.is_moved[i] = 0;
    const std::string drift = round_step(static_cast<std::size_t>(i), *word, stated, increment_mm());
    if (!drift.empty()) to.open = drift;
    if (!to.open.empty()) to.place.xyz[i] = kUnknownValue;
  }
}

std::string SiemensRunner::round_step(std::size_t axis, const SiemensWord& word, double value, double increment) {
  if (is_incremental(word))
    modes_.rounding.add(axis, value, increment);
  else
    modes_.rounding.end(axis);
  return modes_.rounding.why_open(axis, word.name);
}

void SiemensRunner::place_rotaries(Target& to) {
  for (const char letter : {'A', 'B', 'C'}) {
    const SiemensWord* const word = words_.value(std::string_view(&letter, 1));
    if (word == nullptr) continue;
    const auto rotary = motion_.mapper().rotary_of(letter);
    if (!rotary) {
      error_ = describe_missing_axis(letter, setup_.machine.get(), input_.path.file, line_);
      return;
    }
    const double before = to.place.angles.at(*rotary), angle = turned(*word, *rotary, to);
    settle_turn(*word, *rotary, before, angle, to);
    const std::string drift =
        round_step(StepRounding::kFirstRotary + *rotary, *word, word->value, StepRounding::kIncrement_deg);
    if (!drift.empty()) to.open = drift;
    to.place.angles.at(*rotary) = angle;
    to.place.axis.reset();
  }
}

// An axis with DC, ACP or ACN shows angles of one turn. No manual at hand states whether a later word counts the turns before.
void SiemensRunner::settle_turn(const SiemensWord& word, std::size_t rotary, double before, double angle, Target& to) {
  if (is_incremental(word)) return;
  bool& is_open = modes_.is_turn_open.at(rotary);
  if (word.measure != SiemensMeasure::modal && word.measure != SiemensMeasure::absolute) {
    is_open = !is_within_turn(angle / kDegree_rad);
    return;
  }
  if (is_open && std::abs(angle - before) > kRounding_deg * kDegree_rad && to.open.empty())
    to.open =
        word.name + " was taken beyond a turn by DC, ACP or ACN, and no manual states whether the control counts it";
  is_open = false;
}

// The angle that a word states, with its turns, or the reason why the way to it is not known.
double SiemensRunner::turned(const SiemensWord& word, std::size_t rotary, Target& to) const {
  const double before = to.place.angles.at(rotary);
  if (!is_known(word.value)) to.open = "the value of " + word.name + " is not known";
  if (word.measure == SiemensMeasure::modal && !modes_.is_absolute)
    to.open = "nothing states G90 or G91 before this block; expected --start G90";
  if (is_incremental(word)) return before + word.value * kDegree_rad;
  const double stated = motion_.angle_from_program(rotary, word.value);
  const Joint& joint = setup_.machine->joints[setup_.machine->rotary.at(rotary)];
  const double way = (stated - before) / kDegree_rad;
  if (word.measure == SiemensMeasure::modal || word.measure == SiemensMeasure::absolute) {
    const bool is_sure = is_within_turn(before / kDegree_rad) && is_within_turn(stated / kDegree_rad) &&
                         std::abs(way) < kHalfTurn_deg - kRounding_deg;
    const bool stands = std::abs(way) <= kRounding_deg;
    if (is_known(before) && !is_sure && !stands && !has_ends(joint) && !setup_.winds_as_programmed.value_or(false))
      to.open = "machine data state the way of " + word.name + " to this angle; expected --rotary-turns as-programmed";
    return stated;
  }
  // Source: Siemens, Axes and spindles: DC, ACP and ACN take values from 0 to 359.999 degrees.
  if (!(word.value >= 0 && word.value < kTurn_deg))
    to.open = word.name + " with DC, ACP or ACN takes an angle from 0 to 359.999 degrees";
  if (!is_known(before)) return stated;
  const double turn = std::remainder(way, kTurn_deg);
  const bool is_opposite = std::abs(turn) >= kHalfTurn_deg - kRounding_deg;
  if (word.measure == SiemensMeasure::shortest) {
    if (is_opposite) to.open = word.name + " turns by half a turn, either way";
    return before + turn * kDegree_rad;
  }
  const bool stands = std::abs(turn) <= kRounding_deg;
  if (stands) return before;
  const bool is_up = word.measure == SiemensMeasure::positive;
  const double directed = is_up ? (turn > 0 ? turn : turn + kTurn_deg) : (turn < 0 ? turn : turn - kTurn_deg);
  return before + directed * kDegree_rad;
}

// A3, B3 and C3: the direction from the tip to the adapter, in the frame that is in force.
void SiemensRunner::place_vector(Target& to) {
  if (!words_.has_any({"A3", "B3", "C3"})) return;
  modes_.has_vector = true;
  Vec3 direction = Vec3::Zero();
  for (int i = 0; i < 3; ++i) {
    constexpr std::array<std::string_view, 3> kNames = {"A3", "B3", "C3"};
    const SiemensWord* const word = words_.value(kNames.at(static_cast<std::size_t>(i)));
    if (word == nullptr) continue;
    direction[i] = word->value;
    if (word->measure != SiemensMeasure::modal) direction[i] = kUnknownValue;
  }
  const bool has_angles = words_.has_any({"A", "B", "C"});
  const bool is_of_machine = modes_.turn_frame != nullptr && modes_.turn_frame->meaning == Meaning::turn_by_axis;
  const auto axis = direction.allFinite() ? motion_.direction_in_part(direction) : std::nullopt;
  to.place.angles = {kUnknownValue, kUnknownValue};
  to.place.axis = axis;
  if (motion_.tip_control() != TipControl::on)
    to.open = "A3, B3 and C3 without TRAORI";
  else if (has_angles)
    to.open = "A3, B3 or C3 in a block with the angle of a rotary axis";
  else if (is_of_machine)
    to.open = "A3, B3 and C3 in the coordinates of the machine, by ORIMKS";
  else if (!axis)
    to.open = "the direction of the tool is not known";
  if (!to.open.empty()) to.place.axis.reset();
}

void SiemensRunner::move_to_machine_axes(MoveKind kind, const SiemensWords::Code& code) {
  if (code.row->meaning != Meaning::machine_axes || kind == MoveKind::arc)
    return motion_.go_unchecked(
        kind, AxisPlace{},
        here(code.word->name + " states a place that is not known") + "; expected SUPA or G153 with G0 or G1");
  Target to{motion_.place(), {}};
  Vec3 axes = Vec3::Constant(kUnknownValue);
  bool has_step = words_.has_any({"A3", "B3", "C3"});
  for (int i = 0; i < 3; ++i) {
    const SiemensWord* const word = words_.value(std::string_view("XYZ").substr(static_cast<std::size_t>(i), 1));
    if (word == nullptr) continue;
    axes[i] = word->value * mm_per_unit();
    has_step = has_step || is_incremental(*word) || !is_known(word->value);
  }
  const TipControl control = motion_.tip_control();
  if (control == TipControl::on) to.open = code.word->name + " while TRAORI is in force";
  if (control == TipControl::unknown)
    to.open = "nothing states TRAORI or TRAFOOF before " + code.word->name + "; expected --start TRAFOOF";
  // A parameter of the control states whether these words suppress the length too.
  if (modes_.edge > 0 && is_known(axes.z())) to.open = "SUPA or G153 with Z while a length is in force; expected D0";
  place_rotaries(to);
  if (error_) return;
  for (const char letter : {'A', 'B', 'C'}) {
    const SiemensWord* const word = words_.value(std::string_view(&letter, 1));
    if (word == nullptr) continue;
    has_step = has_step || is_incremental(*word);
    // The zero of the rotary axis does not include the work offset.
    const std::size_t rotary = motion_.mapper().rotary_of(letter).value_or(0);
    double& angle = to.place.angles.at(rotary);
    const double shift = motion_.angle_from_program(rotary, 0);
    motion_.note_angle_of_machine(rotary);
    angle = motion_.is_offset_given() && word->measure == SiemensMeasure::modal ? angle - shift : kUnknownValue;
  }
  const std::string missing = missing_fact();
  if (!to.open.empty()) axes.setConstant(kUnknownValue);
  to.place.xyz = missing.empty() && !has_step && to.open.empty() ? motion_.from_machine_axes(axes)
                                                                 : Vec3(Vec3::Constant(kUnknownValue));
  if (!missing.empty() && to.open.empty()) to.open = missing;
  if (has_step && to.open.empty()) to.open = "a place of the machine needs absolute values";
  for (int i = 0; i < 3; ++i) {
    const bool is_stated = is_known(axes[i]);
    if (is_stated && !is_known(to.place.xyz[i]) && to.open.empty())
      to.open =
          "the place of the machine in the coordinates of the part is not known; expected --offset of the work "
          "offset in force, and the length of the tool";
  }
  go(kind, to);
}

}  // namespace gouge
