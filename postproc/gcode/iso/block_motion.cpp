#include <cmath>

#include "lib/base/number_text.h"
#include "postproc/gcode/iso/block_runner.h"

// Motions of a block: the numbers of its words, its target, and the straight way or arc that leads to it.

namespace gouge {

namespace {

using Meaning = GcodeMeaning;

bool moves_axes_itself(const GcodeRow& row) {
  return row.meaning == Meaning::home || row.meaning == Meaning::tilted_plane;
}

}  // namespace

double BlockRunner::number(char letter, double plain_increment) {
  const GcodeWord& word = words_.word(letter);
  if (!is_known(word.value)) lost_ = std::string("the value of ") + letter + " is not known";
  const bool is_plain = !word.has_point && std::abs(word.value) > 0;
  if (!is_plain || index_.control().syntax.numbers == NumberRule::plain) return word.value;
  switch (setup_.plain_numbers) {
    case PlainNumbers::units:
      return word.value;
    case PlainNumbers::increments:
      return word.value * plain_increment;
    case PlainNumbers::not_stated:
      break;
  }
  lost_ = std::string(1, letter) + exact_text(word.value) +
          " has no decimal point, and a parameter of the control states its unit; expected --plain-numbers units or "
          "increments";
  return kUnknownValue;
}

double BlockRunner::length(char letter) {
  if (!modes_.unit && std::abs(words_.value(letter)) > 0) has_assumed_unit_ = true;
  return number(letter, increment_mm() / mm_per_unit()) * mm_per_unit();
}

std::string BlockRunner::round_step(std::size_t axis, char letter, double value, double increment) {
  if (modes_.is_absolute != false) {
    rounding_.end(axis);
    return {};
  }
  if (index_.control().rounds_steps) rounding_.add(axis, value, increment, times_of_steps());
  return rounding_.why_open(axis, std::string_view(&letter, 1));
}

// A block of a cycle makes its steps as often as it drills.
int BlockRunner::times_of_steps() const {
  const bool is_cycle = modes_.motion != nullptr && modes_.motion->meaning == Meaning::cycle;
  return is_cycle ? std::max(times_of_cycle().value_or(1), 1) : 1;
}

// Which of both takes the axis words is not stated; LinuxCNC refuses one in a block with the other.
std::string BlockRunner::why_cycle_open() const {
  const GcodeRow *const stated = words_.row_of(ModalGroup::motion), *const own = find_own_motion();
  const GcodeRow* const motion = stated != nullptr ? stated : modes_.motion;
  const bool is_cycle = motion != nullptr && motion->meaning == Meaning::cycle && own != nullptr &&
                        words_.row_of(ModalGroup::cycle_end) == nullptr;
  if (!is_cycle || (stated == nullptr && !index_.control().syntax.has_macros)) return {};
  return code_text(own->letter, own->number) + " while the cycle " + code_text(motion->letter, motion->number) +
         " is in force; expected G80 before it";
}

// The code of the block that moves to a place of the machine; null: none.
const GcodeRow* BlockRunner::find_own_motion() const {
  for (const GcodeRow* row : words_.rows())
    if (row->meaning == Meaning::home || row->meaning == Meaning::machine_place) return row;
  return nullptr;
}

void BlockRunner::move() {
  if (const std::string open = why_cycle_open(); !open.empty()) return lose_rest(open, line_);
  for (const GcodeRow* row : words_.rows()) {
    if (row->meaning == Meaning::home) {
      motion_.run_by_machine([&] { go_home(*row); });
      return end_length_by(*row);
    }
    if (moves_axes_itself(*row)) return;
  }
  const GcodeRow* const stated = words_.row_of(ModalGroup::motion);
  if (const GcodeRow* const by_machine = words_.row_of(Meaning::machine_place)) {
    if (stated != nullptr) modes_.motion = stated;
    if (!words_.has_axes()) return;
    motion_.run_by_machine([&] { move_to_machine_place(); });
    return end_length_by(*by_machine);
  }
  const bool needs_feed =
      stated != nullptr && stated->meaning != Meaning::rapid && stated->meaning != Meaning::no_motion;
  if (needs_feed && !modes_.has_feed)
    return lose_rest(code_text(stated->letter, stated->number) + " has no feed, so the control refuses it; expected F",
                     line_);
  if (stated != nullptr) {
    const bool begins =
        stated->meaning == Meaning::cycle && (modes_.motion == nullptr || modes_.motion->meaning != Meaning::cycle);
    if (begins) {
      cycle_.start_mm = motion_.place().xyz.z();
      cycle_.open.clear();
    }
    const bool is_at_other_level = std::abs(motion_.place().xyz.z() - cycle_.start_mm) > 0;
    if (!begins && stated->meaning == Meaning::cycle && is_at_other_level && index_.control().levels_may_be_new)
      cycle_.open = "the cycle begins while another one is in force, at another level than that one; expected G80";
    if (stated->meaning == Meaning::cycle && stated != modes_.motion) cycle_.r_mm = cycle_.z_mm = std::nullopt;
    modes_.motion = stated->meaning == Meaning::no_motion ? nullptr : stated;
  } else if (words_.row_of(ModalGroup::cycle_end) != nullptr) {
    modes_.motion = nullptr;
  }
  const GcodeRow* const row = modes_.motion;
  const bool has_arc_words = row != nullptr && words_.has_any("IJKR") &&
                             (row->meaning == Meaning::arc_clockwise || row->meaning == Meaning::arc_counterclockwise);
  if (row != nullptr && row->meaning == Meaning::cycle) return drill(*row);
  if (!words_.has_axes() && !has_arc_words) return;
  if (row == nullptr) return lose_rest("axis words without a motion code before them", line_);
  go_by(*row);
}

void BlockRunner::go_by(const GcodeRow& row) {
  Target to = target();
  if (error_) return;
  if (row.meaning != Meaning::rapid && !modes_.has_feed)
    to.open = "no feed is stated, so the control refuses the motion; expected F";
  const bool is_arc = row.meaning == Meaning::arc_clockwise || row.meaning == Meaning::arc_counterclockwise;
  if (is_arc) return go_round(row, to);
  const MoveKind kind = row.meaning == Meaning::rapid ? MoveKind::rapid : MoveKind::feed;
  if (to.open.empty())
    motion_.go(kind, to.place);
  else
    motion_.go_unchecked(kind, to.place, to.open);
}

void BlockRunner::go_round(const GcodeRow& row, const Target& to) {
  ArcWords arc;
  std::string open = to.open;
  if (modes_.plane)
    arc.plane = *modes_.plane;
  else
    open = "nothing states the plane of the arc before it; expected --start G17";
  arc.is_clockwise = row.meaning == Meaning::arc_clockwise;
  arc.is_centre_absolute = modes_.is_centre_absolute;
  for (std::size_t i = 0; i < 3; ++i) {
    const char letter = "IJK"[i];
    if (words_.has(letter)) arc.centre_mm.at(i) = length(letter);
  }
  if (words_.has('R')) arc.radius_mm = length('R');
  const bool has_turns = words_.has('P');
  if (has_turns) arc.turns = words_.integer('P').value_or(0);
  if (open.empty()) open = lost_;
  const bool is_turning = to.place.angles != motion_.place().angles;
  if (is_turning && !index_.control().turns_along_arcs) open = "no manual states how rotary joints turn along an arc";
  if (open.empty() && motion_.place().xyz.hasNaN()) open = "the place at which the arc begins is not known";
  if (!open.empty()) return motion_.go_unchecked(MoveKind::arc, to.place, open);
  const ArcReading read = read_program_arc(arc, motion_.place().xyz, to.place.xyz);
  if (!read.open.empty()) return motion_.go_unchecked(MoveKind::arc, to.place, read.open);
  motion_.go_round(to.place, read.arc);
}

// Whether an absolute rotary word means the same turn by every parameter of the control. Source: Fanuc, B-63534EN, 20.2.2.
bool BlockRunner::is_turn_stated(std::size_t rotary, double degrees, double way_deg) const {
  constexpr double kHalfTurn_deg = 180, kRounding_deg = 1e-6;
  const RotaryTurns turns = index_.control().turns;
  if (turns == RotaryTurns::as_programmed || std::abs(way_deg) <= kRounding_deg) return true;
  if (std::abs(way_deg) >= kHalfTurn_deg - kRounding_deg) return false;
  // Only an axis without ends rolls over. The way from a place that is not known is no motion that is checked.
  const Joint& joint = setup_.machine->joints[setup_.machine->rotary.at(rotary)];
  return turns != RotaryTurns::may_follow_sign || has_ends(joint) || (degrees >= 0 && !(way_deg < 0));
}

BlockRunner::Target BlockRunner::target() {
  Target to{motion_.place(), {}};
  const bool is_absolute = modes_.is_absolute.value_or(true);
  for (int i = 0; i < 3; ++i) {
    const char letter = "XYZ"[i];
    if (!words_.is_axis(letter)) continue;
    const double value = length(letter);
    const bool is_step = !is_absolute && !(std::abs(value) <= 0);  // G91 G28 Z0 begins without a motion
    if (is_step && !is_known(to.place.xyz[i])) motion_.note_unknown_step();
    to.place.xyz[i] = is_absolute ? value : to.place.xyz[i] + value;
    const std::string drift = round_step(static_cast<std::size_t>(i), letter, value, increment_mm());
    if (lost_.empty()) lost_ = drift;
    if (!modes_.is_absolute || !drift.empty()) to.place.xyz[i] = kUnknownValue;
  }
  for (const char letter : {'A', 'B', 'C'}) {
    if (!words_.is_axis(letter)) continue;
    const auto rotary = motion_.mapper().rotary_of(letter);
    if (!rotary) {
      error_ = describe_missing_axis(letter, setup_.machine.get(), path_.file, line_);
      return to;
    }
    double& angle = to.place.angles.at(*rotary);
    const double degrees = number(letter, StepRounding::kIncrement_deg);
    const double before = angle;
    angle = is_absolute ? motion_.angle_from_program(*rotary, degrees) : angle + degrees * kDegree_rad;
    const std::string drift =
        round_step(StepRounding::kFirstRotary + *rotary, letter, degrees, StepRounding::kIncrement_deg);
    if (lost_.empty()) lost_ = drift;
    if (!modes_.is_absolute || !drift.empty()) angle = kUnknownValue;
    const bool may_turn_otherwise = modes_.is_absolute == true && !setup_.winds_as_programmed.value_or(false) &&
                                    !is_turn_stated(*rotary, degrees, (angle - before) / kDegree_rad);
    if (may_turn_otherwise)
      to.open = std::string("a parameter of the control may change the turn of ") + letter +
                "; expected --rotary-turns as-programmed";
  }
  if (!modes_.is_absolute) to.open = "nothing states G90 or G91 before this block; expected --start G90";
  if (to.open.empty()) to.open = lost_;
  return to;
}

}  // namespace gouge
