#include "postproc/gcode/iso/block_runner.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lib/base/number_text.h"
#include "postproc/gcode/running/program_text.h"

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
  const std::string wrong = block.error.empty() ? words_.take(block, index_, modes_.motion) : block.error;
  if (!wrong.empty()) motion_.is_rest_unknown() ? note_further_word(wrong, line, input_) : lose_rest(wrong, line);
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
  if (words_.has('T')) take_tool();
  if (motion_.is_rest_unknown()) return;
  if (words_.row_of(Meaning::tool_change) != nullptr) change_tool();
  const double height_mm = motion_.place().xyz.z();
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
  const GcodeRow *const call = words_.row_of(Meaning::tip_control_on), *const offset =
                                                                           words_.row_of(Meaning::work_offset);
  if (call != nullptr || offset != nullptr) settle_tip_frame(call != nullptr ? *call : *offset, call != nullptr);
  note_level_of_cycle(height_mm);
}

// No manual at hand states whether the level to which a cycle retracts stays where it is in the machine.
void BlockRunner::note_level_of_cycle(double before_mm) {
  const bool is_cycle = modes_.motion != nullptr && modes_.motion->meaning == Meaning::cycle;
  if (is_cycle && std::abs(motion_.place().xyz.z() - before_mm) > 0)
    cycle_.open = "the work offset, the length or the frame changes" + in_line(line_) +
                  " while a cycle is in force, and Z of the level at which it began with it; expected G80 before it";
}

// Makes a tool ready for the next change.
void BlockRunner::take_tool() {
  const std::optional<int> stated = words_.integer('T');
  if (!stated || *stated < 0) return lose_rest("the number of the tool is not known", line_);
  const bool is_change = words_.row_of(Meaning::tool_change) != nullptr;
  if (is_change && modes_.has_waiting_tool && modes_.next_tool != stated && index_.control().may_load_waiting_tool)
    return lose_rest("T" + std::to_string(*stated) + " stands beside M6 while T" + std::to_string(*modes_.next_tool) +
                         " is waiting, and the builder of the machine states which of both is loaded; expected T in a "
                         "block before M6",
                     line_);
  modes_.next_tool = stated;
  modes_.has_waiting_tool = true;
}

// The modes that only give words a meaning.
void BlockRunner::take_code(const GcodeRow& row) {
  switch (row.meaning) {
    case Meaning::spindle_on:
    case Meaning::spindle_off:
      motion_.stop_spindle(row.meaning == Meaning::spindle_off);
      break;
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

// The time of motions depends on a feed, and no depth. So it is no reason not to check them.
void BlockRunner::note_unknown_feed() {
  if (std::exchange(has_noted_feed_, true)) return;
  path_.notes.push_back(
      make_note("gcode-feed", "the feed rate is not known from here on: " + lost_, path_.file, line_));
}

void BlockRunner::take_feed() {
  const double feed = number('F', 1);
  if (words_.value('F') < 0) return lose_rest("the feed is below 0", line_);
  modes_.has_feed = !(words_.value('F') <= 0);
  const bool is_time = modes_.feed_unit == FeedUnit::not_understood;
  modes_.feed = is_known(feed) && feed > 0 ? std::optional(is_time ? feed : feed * mm_per_unit()) : std::nullopt;
  if (!is_known(feed)) note_unknown_feed();
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
    motion_.doubt(kind, std::string(row.note) + ", by " + code_text(row.letter, row.number) + in_line(line_));
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
  const std::string where = line_ == 0 ? ", in force at the start," : in_line(line_);
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

}  // namespace gouge
