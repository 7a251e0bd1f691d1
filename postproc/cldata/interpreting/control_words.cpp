#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "lib/base/number_text.h"
#include "lib/base/tolerance.h"
#include "postproc/cldata/interpreting/emit.h"
#include "postproc/cldata/interpreting/further_readings.h"
#include "postproc/cldata/interpreting/misreading.h"
#include "postproc/cldata/interpreting/word_handlers.h"
#include "postproc/cldata/language/text.h"
#include "postproc/cldata/parsing/cutter_statement.h"
#include "postproc/cldata/parsing/machine_text.h"

// Handlers for statements with text or codes for the machine's control, and for choices of the setup. Some of them may
// move the tool or change the place of positions.

namespace gouge {
namespace {

bool is_zero(const Argument& argument) { return argument.number && std::abs(*argument.number) <= 0; }

// Notes a work offset. Only the control knows the difference between two offsets. Without a choice the first one is in
// force.
void choose_offset(States& s, const std::string& offset) {
  constexpr std::string_view kFirst = "G54";
  s.offsets_chosen.add(s.in.line());
  if (s.work_offset.empty()) s.work_offset = s.in.moves() > 0 ? kFirst : offset;
  const bool is_same = s.work_offset == offset;
  if (s.in.moves() == 0) s.work_offset = offset;
  if (is_same || s.in.moves() == 0) return s.uncertainties.clear(Uncertainty::work_offset);
  s.in.count_unknown();
  s.uncertainties.set(Uncertainty::work_offset, s.in.because(Reasons::kWorkOffset));
}

// Takes PREFUN/g and AUXFUN/m, which are a G and an M of the control. The addresses after them belong to the same
// block.
void take_codes(States& s, char letter) {
  constexpr std::array<std::string_view, 3> kWhen = {"NOW", "NEXT", "ON"};
  std::string block;
  for (const Argument& argument : s.in.arguments) {
    if (is_one_of(argument.text, kWhen)) continue;
    const bool is_letter_alone = argument.text.size() == 1 && is_letter(argument.text[0]);
    const bool is_value = argument.number && !block.empty() && is_letter(block.back());
    if (argument.number && !is_value) block += letter;
    block += argument.number ? exact_text(*argument.number) : std::string(argument.text);
    if (!is_letter_alone) block += ' ';
  }
  take_machine_text(s, read_machine_text(block));
}

// Notes text that lets the control leave the path, or turn the axis otherwise.
void take_path_law(States& s, const MachineEffect& effect) {
  if (effect.smooths && s.smoothing_line == 0) s.smoothing_line = s.in.line();
  if (effect.smoothing) s.smoothing_mm = std::max(s.smoothing_mm, *effect.smoothing * s.frame.mm_per_unit());
  if (effect.turns_axes && s.joint_law_line == 0) s.joint_law_line = s.in.line();
}

void take_modes(States& s, const MachineEffect& effect) {
  const bool is_in_cycle = s.cycle.is_on() && changes_cycle(effect);
  if (!effect.plane && !effect.centres_absolute && !effect.level_at_start && !is_in_cycle) return;
  const char* const reason = s.in.because(Reasons::kMachineMode);
  if (effect.plane) s.control_modes.take_plane(*effect.plane, reason);
  if (effect.centres_absolute) s.control_modes.take_centres(*effect.centres_absolute, reason);
  if (effect.level_at_start) s.control_modes.take_level(*effect.level_at_start, reason);
  if (is_in_cycle) s.cycle.doubt(reason);
}

// Returns whether text ends a compensation or a tilted plane that the file has in force.
bool moves_tool_off(const States& s, const MachineEffect& effect) {
  if (effect.ends_compensation && s.cutcom.side() != CutcomSide::none) return true;
  if (!effect.ends_tilt || !s.chain.last_pose()) return false;
  return s.frame.to_local(*s.chain.last_pose()).axis.z() < 1 - Tolerance::kExactDirection;
}

}  // namespace

// Applies the effects of text for the control. A code that ends a shift need not end the one in force. A code that ends
// cycles or steps ends all of them.
void take_machine_text(States& s, const MachineEffect& effect) {
  const bool is_other_unit = effect.unit && std::abs(mm_per(*effect.unit) - s.frame.mm_per_unit()) > 0;
  if (effect.is_unknown) return take_unknown_statement(s);
  take_path_law(s, effect);
  if (has_effect(effect)) contradict_skip(s);
  if (effect.stops_spindle) s.feed.stop_spindle(*effect.stops_spindle);
  if (effect.motion_code) s.control_motion.take_text(*effect.motion_code, s.in.because(Reasons::kMachineMotion));
  take_modes(s, effect);
  const bool moves = effect.moves || effect.changes_tool;
  const bool shifts = effect.shifts || is_other_unit || moves_tool_off(s, effect);
  if (!effect.work_offset.empty()) choose_offset(s, effect.work_offset);
  if (moves || shifts || effect.changes_length || effect.begins_cycle || effect.begins_steps) s.in.count_unknown();
  if (moves) emit_unread(s);
  const auto uncertainty = [&](Uncertainty which, const char* reason) {
    s.uncertainties.set(which, s.in.because(reason));
  };
  if (effect.changes_length) uncertainty(Uncertainty::loading, Reasons::kMachineShift);
  if (effect.changes_tool) uncertainty(Uncertainty::loading, Reasons::kUnreadTool);
  if (shifts) uncertainty(Uncertainty::machine_shift, Reasons::kMachineShift);
  if (effect.ends_cycle) s.uncertainties.clear(Uncertainty::machine_cycle);
  if (effect.begins_cycle) uncertainty(Uncertainty::machine_cycle, Reasons::kMachineCycle);
  if (effect.ends_steps) s.uncertainties.clear(Uncertainty::machine_steps);
  if (effect.begins_steps) uncertainty(Uncertainty::machine_steps, Reasons::kMachineSteps);
  if (effect.ends_program) end_program(s);
}

// Takes INSERT. SolidWorks CAM writes names of tools, setups and stock there; the name of a tool is right before its
// CUTTER.
void take_insert(States& s) {
  const std::string_view text = s.in.first_piece();
  s.tool.take_insert(text);
  const MachineEffect effect = read_machine_text(text);
  if (!s.in.dialect.inserts_are_names || !effect.is_unknown) return take_machine_text(s, effect);
  if (!is_setup_text(text)) s.pending = PendingInsert{s.in.index(), is_tool_name(text)};
}

// Decides at the word `next` whether the pending text was a name, or was not understood.
void settle_insert(States& s, Word next) {
  if (!s.pending || next == Word::comment) return;
  const PendingInsert pending = *std::exchange(s.pending, std::nullopt);
  if (pending.is_name && next == Word::cutter) return;
  s.in.count_unknown("INSERT");
  mark_all_uncertain(s, "INSERT", pending.statement);
}

void take_prefun(States& s) { take_codes(s, 'G'); }

// Takes AUXFUN. Three or more numbers, or a negative one, are the position of another line.
void take_auxfun(States& s) {
  const NumberCount numbers = count_numbers(s.in.arguments);
  if (numbers.count >= 3 || numbers.negative > 0) return take_unknown_statement(s);
  take_codes(s, 'M');
}

// Takes SETUP. SolidWorks CAM begins and ends its setups with SETUP/START,n and SETUP/END,n.
void take_setup(States& s) {
  const std::vector<Argument>& arguments = s.in.arguments;
  const bool is_mark =
      arguments.size() <= 2 && !arguments.empty() &&
      (equals_ignoring_case(arguments.front().text, "START") || equals_ignoring_case(arguments.front().text, "END"));
  if (is_mark || arguments.empty()) return;
  if (std::all_of(arguments.begin(), arguments.end(), is_zero)) return;
  const bool is_offset = s.in.dialect.operations_are_blocks && equals_ignoring_case(s.in.statement().major, "ZERO") &&
                         s.in.has_numbers_alone(1) && *arguments.front().number > 0;
  if (is_offset) return choose_offset(s, "ZERO " + exact_text(*arguments.front().number));
  s.in.count_unknown();
  s.uncertainties.set(Uncertainty::setup, s.in.because(Reasons::kSetup));
}

// Takes SELECT. SELECT/TOOL,n prepares the next tool. An origin or a head changes the place of positions.
void take_select(States& s) {
  if (s.in.arguments.empty() || equals_ignoring_case(s.in.arguments.front().text, "TOOL")) return;
  s.in.count_unknown();
  s.uncertainties.set(Uncertainty::setup, s.in.because(Reasons::kSetup));
}

}  // namespace gouge
