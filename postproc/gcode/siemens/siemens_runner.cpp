#include "postproc/gcode/siemens/siemens_runner.h"

#include <algorithm>
#include <cmath>

#include "lib/base/number_text.h"
#include "postproc/gcode/running/program_text.h"

namespace gouge {
namespace {

using Meaning = SiemensMeaning;

std::optional<int> whole_number(const SiemensWord& word) {
  constexpr double kMaxNumber = 1e9;
  if (!(std::abs(word.value) <= kMaxNumber) || std::abs(word.value - std::round(word.value)) > 0) return std::nullopt;
  return static_cast<int>(std::lround(word.value));
}

}  // namespace

double siemens_argument(const SiemensWord& word, std::size_t index, double absent) {
  return index < word.arguments.size() && !word.arguments[index].is_empty ? word.arguments[index].value : absent;
}

SiemensRunner::SiemensRunner(const ProgramInput& input, bool changes_tool_by_m6)
    : input_(input), setup_(input.options.setup), motion_(input.motion), changes_tool_by_m6_(changes_tool_by_m6) {
  modes_.unit = input.options.unit;
  if (motion_.mapper().has_machine()) motion_.set_tip_control(TipControl::unknown);
  settle_path();
}

void SiemensRunner::lose_rest(const std::string& reason, std::size_t line) {
  if (motion_.is_rest_unknown()) return;
  lost_line_ = line;
  lose_program(reason, line, input_);
}

std::string SiemensRunner::here(const std::string& what) const { return what + in_line(line_); }

SiemensNext SiemensRunner::run(const SiemensBlock& block, std::size_t line) {
  line_ = line;
  std::string wrong = block.error.empty() ? words_.take(block, input_.options.harmless_words) : block.error;
  if (wrong.empty() && !block.assignments.empty() && !block.words.empty())
    wrong = block.assignments.front().variable + " is set in a block with other words";
  if (!wrong.empty()) motion_.is_rest_unknown() ? note_further_word(wrong, line, input_) : lose_rest(wrong, line);
  if (motion_.is_rest_unknown()) {
    const bool may_move = !block.words.empty() || !block.error.empty();
    if (may_move && lost_line_ != line) motion_.go_unchecked(MoveKind::feed, AxisPlace{}, {});
    return {};
  }
  if (block.words.empty()) return {};
  take_codes();
  if (motion_.is_rest_unknown() || error_) return {};
  const bool has_lengths =
      words_.has_axes() || words_.has_arc_words() || words_.code_of(SiemensGroup::frame) != nullptr;
  if (!modes_.unit && has_lengths) modes_.has_places_without_unit = true;
  move();
  return take_flow();
}

void SiemensRunner::take_codes() {
  using Group = SiemensGroup;
  for (const SiemensWords::Code& code : words_.codes()) take_mode(code);
  const bool are_times = words_.code(Meaning::dwell) != nullptr;
  if (!are_times && words_.value("F") != nullptr) take_feed();
  take_spindle(are_times);
  if (const auto* offset = words_.code(Meaning::work_offset)) take_offset(offset->word->name);
  take_length_and_tool();
  const auto has_code = [&](Group group) { return words_.code_of(group) != nullptr; };
  if (const auto* code = words_.code_of(Group::transformation)) take_transformation(*code);
  if (const auto* code = words_.code_of(Group::frame)) take_frame(*code);
  const bool changes_frame = has_code(Group::frame) || has_code(Group::transformation) || has_code(Group::plane) ||
                             has_code(Group::work_offset) || words_.value("D") != nullptr;
  if (changes_frame) settle_frame();
  const bool changes_path = has_code(Group::path_control) || has_code(Group::compressor) ||
                            has_code(Group::turn_frame) || has_code(Group::turn_path) || has_code(Group::rapid_kind) ||
                            words_.has_any({"ADIS", "ADISPOS", "CTOL", "OTOL"});
  if (changes_path) take_blending();
}

// The modes that only give words a meaning.
void SiemensRunner::take_mode(const SiemensWords::Code& code) {
  switch (code.row->meaning) {
    case Meaning::spindle_on:
    case Meaning::spindle_off:
      motion_.stop_spindle(code.row->meaning == Meaning::spindle_off);
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
    case Meaning::absolute:
    case Meaning::incremental:
      modes_.is_absolute = code.row->meaning == Meaning::absolute;
      break;
    case Meaning::mm:
      take_unit(LengthUnit::mm, code.word->name);
      break;
    case Meaning::inch:
      take_unit(LengthUnit::inch, code.word->name);
      break;
    case Meaning::feed_inverse:
    case Meaning::feed_per_minute:
    case Meaning::feed_per_revolution:
      modes_.feed_unit = code.row->meaning == Meaning::feed_per_minute       ? FeedUnit::per_minute
                         : code.row->meaning == Meaning::feed_per_revolution ? FeedUnit::per_revolution
                                                                             : FeedUnit::not_understood;
      modes_.feed.reset();
      set_feed();
      break;
    case Meaning::message: {
      const std::vector<SiemensArgument>& arguments = code.word->arguments;
      if (!arguments.empty() && !arguments[0].text.empty()) motion_.name_operation(arguments[0].text);
      break;
    }
    case Meaning::compensation_off:
      motion_.end_doubt(ProgramDoubt::compensation);
      break;
    case Meaning::not_checked:
      motion_.doubt(ProgramDoubt::compensation, here(std::string(code.row->note) + ", by " + code.word->name));
      break;
    default:
      break;
  }
}

void SiemensRunner::take_unit(LengthUnit unit, const std::string& word) {
  if (modes_.has_places_without_unit)
    return lose_rest(
        word + " states the unit, and positions stand before it; expected the unit at the start: --start G71 or G70",
        line_);
  if (unit_line_ == 0) {
    unit_line_ = line_;
    unit_word_ = word;
    input_.path.unit = unit;
  }
  // A basic system of the other unit changes what feeds mean, never what lengths mean.
  if (modes_.unit && *modes_.unit != unit && (word == "G70" || word == "G71")) modes_.feed.reset();
  modes_.unit = unit;
  input_.path.is_unit_stated = true;
}

void SiemensRunner::take_feed() {
  const double feed = words_.value("F")->value;
  modes_.feed = is_known(feed) && feed > 0 ? std::optional(feed * mm_per_unit()) : std::nullopt;
  set_feed();
}

// Takes the words of the spindle. In a block with G4, S is a time.
void SiemensRunner::take_spindle(bool is_dwell) {
  for (const char* const name : {"S", "S1"}) {
    const SiemensWord* const word = is_dwell ? nullptr : words_.value(name);
    if (word != nullptr) motion_.set_spindle(word->value);
  }
  constexpr double kFirstStop = 5;  // of 3, 4, 5 and 19
  if (words_.value("SPOS") != nullptr) motion_.stop_spindle(true);
  if (const SiemensWord* const code = words_.value("M1")) motion_.stop_spindle(code->value >= kFirstStop);
}

void SiemensRunner::set_feed() {
  const bool is_understood = modes_.feed_unit != FeedUnit::not_understood;
  motion_.set_feed(modes_.feed && is_understood
                       ? Feed{*modes_.feed, modes_.feed_unit}
                       : Feed{0, is_understood ? FeedUnit::not_stated : FeedUnit::not_understood});
}

void SiemensRunner::take_offset(const std::string& name) {
  modes_.is_moved.setOnes();
  // The part is at the first offset of the program. G500 ends offsets, and is none of the part.
  const bool is_given = setup_.zero.has_value() || setup_.offsets.contains(name);
  modes_.is_offset_stated = name != "G500" || is_given || !motion_.part_offset().empty();
  if (!modes_.is_offset_stated) return;
  if (offset_line_ == 0 && line_ > 0) offset_line_ = line_;
  motion_.choose_offset(name);
}

void SiemensRunner::take_length_and_tool() {
  if (const SiemensWord* const tool = words_.value("T")) {
    if (tool->text.empty() && !whole_number(*tool)) return lose_rest("T states a tool that is not known", line_);
    modes_.next_tool = *tool;
  }
  const auto* const change = words_.code(Meaning::tool_change);
  const bool has_stated_tool = words_.value("T") != nullptr;
  if (has_stated_tool && (words_.has_axes() || words_.has_arc_words()))
    return lose_rest("T stands in a block with axis words", line_);
  const bool loads_at_once = has_stated_tool && !changes_tool_by_m6_;
  if (loads_at_once && change == nullptr && loading_line_ == 0) loading_line_ = line_;
  if (change != nullptr || loads_at_once) change_tool();
  if (const SiemensWord* const edge = words_.value("D")) take_length(*edge);
}

void SiemensRunner::change_tool() {
  if (!modes_.next_tool) return lose_rest("M6 without a tool that T states", line_);
  const SiemensWord stated = *modes_.next_tool;
  modes_.next_tool.reset();
  const auto number = whole_number(stated);
  modes_.open_length = here("nothing states D after the change of the tool");
  if (stated.text.empty() && number == 0) {
    modes_.open_length = here("the spindle holds no tool, by T0");
    return motion_.doubt(ProgramDoubt::length, modes_.open_length);
  }
  PathTool tool;
  tool.name = stated.text;
  if (stated.text.empty()) tool.number = number;
  tool.line = line_;
  motion_.end_doubt(ProgramDoubt::length);
  motion_.change_tool(tool);
}

void SiemensRunner::take_length(const SiemensWord& word) {
  const auto number = whole_number(word);
  if (!number || *number < 0) return lose_rest("D states a cutting edge that is not known", line_);
  modes_.is_moved.setOnes();
  if (modes_.open_length.find("holds no tool") != std::string::npos) return;
  modes_.open_length.clear();
  modes_.edge = *number;
  motion_.end_doubt(ProgramDoubt::length);
  if (*number > 0)
    motion_.apply_length(std::nullopt);
  else
    motion_.cancel_length();
}

void SiemensRunner::take_transformation(const SiemensWords::Code& code) {
  const bool is_on = code.row->meaning == Meaning::tip_control_on;
  const std::vector<SiemensArgument>& arguments = code.word->arguments;
  const bool is_first = arguments.empty() || (arguments.size() == 1 && std::abs(arguments[0].value - 1) <= 0);
  if (!is_first || (!is_on && !arguments.empty()))
    return lose_rest(code.word->name + " has arguments that are not read", line_);
  const TipControl before = motion_.tip_control(), after = is_on ? TipControl::on : TipControl::off;
  if (before == after) return;
  // No manual at hand states what becomes of the frames of the program.
  if (modes_.frame) modes_.open_frame = here(code.word->name + " stands while a frame of the program is in force");
  if (modes_.has_swivel) modes_.open_swivel = here(code.word->name + " stands while a frame of CYCLE800 is in force");
  motion_.set_tip_control(after);
  modes_.is_moved.setOnes();
  settle_path();
}

SiemensNext SiemensRunner::take_flow() {
  for (const SiemensWords::Code& code : words_.codes()) {
    if (code.row->meaning == Meaning::program_end) return {SiemensNext::Kind::end, {}, 1};
    if (code.row->meaning == Meaning::back) return {SiemensNext::Kind::back, {}, 1};
  }
  if (words_.called().empty()) return {};
  const SiemensWord* const times = words_.value("P");
  const auto count = times == nullptr ? std::optional(1) : whole_number(*times);
  constexpr int kMaxTimes = 9999;
  if (!count || *count < 1 || *count > kMaxTimes) {
    lose_rest("P states a number of calls that is not known", line_);
    return {};
  }
  return {SiemensNext::Kind::call, words_.called(), *count};
}

double SiemensRunner::mm_per_unit() const { return mm_per(modes_.unit.value_or(LengthUnit::mm)); }

double SiemensRunner::length(std::string_view address) const { return words_.value(address)->value * mm_per_unit(); }

bool SiemensRunner::is_incremental(const SiemensWord& word) const {
  if (word.measure == SiemensMeasure::modal) return modes_.is_absolute == false;
  return word.measure == SiemensMeasure::incremental;
}

}  // namespace gouge
