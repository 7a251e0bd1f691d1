#include "postproc/gcode/iso/block_runner.h"

#include <algorithm>
#include <cmath>

#include "lib/base/number_text.h"

namespace gouge {
namespace {

using Meaning = GcodeMeaning;

ProgramDoubt doubt_of(ModalGroup group) {
  switch (group) {
    case ModalGroup::compensation:
      return ProgramDoubt::compensation;
    case ModalGroup::frame:
      return ProgramDoubt::frame;
    case ModalGroup::length:
      return ProgramDoubt::length;
    case ModalGroup::path_control:
      return ProgramDoubt::path_control;
    default:
      return ProgramDoubt::rest;
  }
}

bool moves_axes_itself(const GcodeRow& row) {
  return row.meaning == Meaning::home || row.meaning == Meaning::tilted_plane;
}

}  // namespace

BlockRunner::BlockRunner(const CodeIndex& index, const ProgramInput& input)
    : index_(index), input_(input), setup_(input.options.setup), motion_(input.motion), path_(input.path) {
  modes_.unit = input.options.unit;
}

void BlockRunner::lose_rest(const std::string& reason, std::size_t line) {
  if (motion_.is_rest_unknown()) return;
  lost_line_ = line;
  lose_program(reason, line, input_);
}

NextBlock BlockRunner::run(const GcodeBlock& block, std::size_t line) {
  line_ = line;
  lost_.clear();
  if (!block.error.empty()) {
    lose_rest(block.error, line);
  } else if (!motion_.is_rest_unknown()) {
    const std::string wrong = words_.take(block, index_, modes_.motion);
    if (!wrong.empty()) lose_rest(wrong, line);
  }
  if (motion_.is_rest_unknown()) {
    if (lost_line_ == line) return {};
    const bool may_move = std::ranges::any_of(block.words, [](const GcodeWord& word) { return word.letter != 'M'; });
    if (may_move || !block.error.empty()) motion_.go_unchecked(MoveKind::feed, AxisPlace{}, {});
    return {};
  }
  if (block.words.empty()) {
    if (!block.comment.empty()) motion_.name_operation(std::string(trim_blanks(block.comment)));
    return {};
  }
  take_modes();
  if (motion_.is_rest_unknown()) return {};
  move();
  if (modes_.feed_unit == FeedUnit::not_understood) {  // F holds for its block
    motion_.set_inverse_time(std::nullopt);
    modes_.has_feed = false;
  }
  return take_flow();
}

bool BlockRunner::has_end(const GcodeBlock& block) const {
  return std::ranges::any_of(block.words, [&](const GcodeWord& word) {
    const GcodeRow* const row = word.letter == 'M' ? index_.row(word) : nullptr;
    return row != nullptr && row->meaning == Meaning::program_end;
  });
}

void BlockRunner::take_modes() {
  for (const GcodeRow* row : words_.rows()) take_code(*row);
  if (words_.has('F')) take_feed();
  if (words_.has('S') && !(words_.value('S') >= 0)) return lose_rest("the speed of the spindle is not known", line_);
  if (words_.has('S')) motion_.set_spindle(words_.value('S'));
  if (words_.has('T')) {
    const std::optional<int> stated = words_.integer('T');
    if (!stated || *stated < 0) return lose_rest("the number of the tool is not known", line_);
    const bool is_change = words_.row_of(Meaning::tool_change) != nullptr;
    if (is_change && modes_.has_waiting_tool && modes_.next_tool != stated && index_.control().may_load_waiting_tool)
      return lose_rest(
          "T" + std::to_string(*stated) + " stands beside M6 while T" + std::to_string(*modes_.next_tool) +
              " is waiting, and the builder of the machine states which of both is loaded; expected T in a "
              "block before M6",
          line_);
    modes_.next_tool = stated;
    modes_.has_waiting_tool = true;
  }
  if (words_.row_of(Meaning::tool_change) != nullptr) change_tool();
  for (const GcodeRow* row : words_.rows()) take_path_control(*row);
  take_lengths();
  for (const GcodeRow* row : words_.rows()) {
    if (row->meaning == Meaning::work_offset) take_offset(*row);
    if (row->meaning == Meaning::tilted_plane) take_tilted_plane();
    if (row->meaning == Meaning::align_to_plane) motion_.align_to_plane();
    if (row->meaning == Meaning::tilted_plane_off) {
      motion_.set_plane(std::nullopt);
      motion_.end_doubt(ProgramDoubt::frame);
    }
  }
}

// The modes that only give words a meaning.
void BlockRunner::take_code(const GcodeRow& row) {
  switch (row.meaning) {
    case Meaning::plane_xy:
      modes_.plane = PlaneAxes{0, 1, 2};
      break;
    case Meaning::plane_zx:
      modes_.plane = PlaneAxes{2, 0, 1};
      break;
    case Meaning::plane_yz:
      modes_.plane = PlaneAxes{1, 2, 0};
      break;
    case Meaning::inch:
    case Meaning::mm:
      if (const auto unit = row.meaning == Meaning::inch ? LengthUnit::inch : LengthUnit::mm;
          modes_.unit && *modes_.unit != unit && words_.has_axes() && index_.control().syntax.has_macros)
        return lose_rest(code_text(row.letter, row.number) +
                             " changes the unit in a block with axis words; expected a block of its own",
                         line_);
      if (modes_.motion != nullptr && modes_.motion->meaning == Meaning::cycle)
        cycle_.open =
            "the unit is stated while a cycle is in force, whose R and Z are in the unit before; expected G80";
      modes_.unit = row.meaning == Meaning::inch ? LengthUnit::inch : LengthUnit::mm;
      if (unit_line_ == 0) {
        unit_line_ = line_;
        path_.unit = *modes_.unit;
      }
      path_.is_unit_stated = true;
      break;
    case Meaning::absolute:
    case Meaning::incremental:
      modes_.is_absolute = row.meaning == Meaning::absolute;
      break;
    case Meaning::centre_absolute:
    case Meaning::centre_incremental:
      modes_.is_centre_absolute = row.meaning == Meaning::centre_absolute;
      break;
    case Meaning::feed_inverse:
    case Meaning::feed_per_minute:
    case Meaning::feed_per_revolution:
      modes_.feed_unit = row.meaning == Meaning::feed_per_minute       ? FeedUnit::per_minute
                         : row.meaning == Meaning::feed_per_revolution ? FeedUnit::per_revolution
                                                                       : FeedUnit::not_understood;
      modes_.feed.reset();
      modes_.has_feed = false;
      set_feed();
      break;
    case Meaning::cycle_to_start:
    case Meaning::cycle_to_plane:
      modes_.retracts_to_start = row.meaning == Meaning::cycle_to_start;
      break;
    default:
      break;
  }
}

void BlockRunner::take_feed() {
  const double feed = number('F', 1);
  if (words_.value('F') < 0) return lose_rest("the feed is below 0", line_);
  modes_.has_feed = !(words_.value('F') <= 0);
  const bool is_time = modes_.feed_unit == FeedUnit::not_understood;
  modes_.feed = is_known(feed) && feed > 0 ? std::optional(is_time ? feed : feed * mm_per_unit()) : std::nullopt;
  lost_.clear();  // only the time of the motion depends on it
  set_feed();
}

void BlockRunner::set_feed() {
  if (modes_.feed_unit == FeedUnit::not_understood) return motion_.set_inverse_time(modes_.feed);
  motion_.set_feed(modes_.feed ? Feed{*modes_.feed, modes_.feed_unit} : Feed{});
}

// Codes that make later motions leave the programmed path, and those that end it.
void BlockRunner::take_path_control(const GcodeRow& row) {
  const ProgramDoubt kind = doubt_of(row.group);
  if (row.meaning == Meaning::not_checked) {
    motion_.doubt(kind, std::string(row.note) + ", by " + code_text(row.letter, row.number) + " in line " +
                            std::to_string(line_));
    return;
  }
  if (row.meaning == Meaning::harmless && kind != ProgramDoubt::rest) {
    motion_.end_doubt(kind);
    if (kind == ProgramDoubt::path_control) motion_.doubt_turns({});
  }
  if (row.meaning == Meaning::blending) take_blending(row);
}

// Source: LinuxCNC, G64: P0 is no tolerance; moves that are within Q of a line are one move, which P rounds in addition.
void BlockRunner::take_blending(const GcodeRow& row) {
  double distance_mm = kUnknownValue, least_mm = 0;
  for (const char letter : row.distance) {
    const double stated = words_.has(letter) ? length(letter) : 0;
    least_mm += is_known(stated) ? stated : 0;
    distance_mm = letter != row.distance.front() ? distance_mm + stated : stated > 0 ? stated : kUnknownValue;
  }
  lost_.clear();  // an unknown distance is one that the user covers, or a doubt
  const std::string where = line_ == 0 ? ", in force at the start," : " in line " + std::to_string(line_);
  const std::string word = code_text(row.letter, row.number) + where;
  // No manual at hand states a bound for the rotary joints.
  motion_.doubt_turns(
      setup_.axis_tolerance_rad
          ? ""
          : word + " lets the tool turn away from its path by an unknown angle; expected --axis-tolerance");
  if (setup_.tip_tolerance_mm && !(least_mm > *setup_.tip_tolerance_mm))
    return motion_.end_doubt(ProgramDoubt::path_control);
  const std::string by = is_known(distance_mm) ? display_text(distance_mm, 4) + " mm" : "an unknown distance";
  const bool is_start = line_ == 0;
  motion_.doubt(ProgramDoubt::path_control,
                word + " lets the tool leave its path by " + by +
                    (is_start ? "; expected --start G61 or --tip-tolerance" : "; expected --tip-tolerance"));
}

void BlockRunner::change_tool() {
  PathTool tool;
  tool.number = modes_.next_tool;
  tool.line = line_;
  motion_.change_tool(tool);
  modes_.has_waiting_tool = false;
}

NextBlock BlockRunner::take_flow() {
  const auto p = words_.integer('P'), times = words_.integer('L');
  for (const GcodeRow* row : words_.rows()) {
    switch (row->meaning) {
      case Meaning::program_end:
        has_ended_ = true;
        return {NextBlock::Kind::end};
      case Meaning::return_from_call:
        return {NextBlock::Kind::back};
      case Meaning::call_program:
      case Meaning::call_block: {
        const bool is_wrong = !p || (words_.has('L') && (!times || *times < 1));
        if (is_wrong) {
          lose_rest("the program that is called is not known", line_);
          return {};
        }
        const auto kind =
            row->meaning == Meaning::call_block ? NextBlock::Kind::call_block : NextBlock::Kind::call_program;
        return {kind, *p, times.value_or(1)};
      }
      default:
        break;
    }
  }
  return {};
}

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
    if (!is_absolute && !is_known(to.place.xyz[i])) motion_.note_unknown_step();
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
