#include <algorithm>
#include <cmath>
#include <string>

#include "lib/base/number_text.h"
#include "postproc/cldata/interpreting/emit.h"
#include "postproc/cldata/interpreting/misreading.h"
#include "postproc/cldata/interpreting/word_handlers.h"
#include "postproc/cldata/language/text.h"
#include "postproc/cldata/parsing/machine_text.h"

// Statements that carry text or codes for the machine's control, and choices of the setup: what of them may
// move the tool or change where positions are.

namespace gouge {
namespace {

bool is_zero(const Argument& argument) { return argument.number && std::abs(*argument.number) <= 0; }

// PREFUN/g and AUXFUN/m are a G and an M of the control.
void take_codes(States& s, char letter) {
  for (const Argument& argument : s.in.arguments) {
    const std::string code = argument.number ? letter + exact_text(*argument.number) : std::string(argument.text);
    MachineEffect effect = read_machine_text(code, false);
    effect.is_unknown = effect.is_unknown && argument.number.has_value();
    take_machine_text(s, effect);
  }
}

}  // namespace

// What stands between ON and OFF is run or not, by a switch of the control. A tool, a frame or a cycle that begins or
// ends there may hold behind it, or not.
void take_opskip(States& s) {
  const bool is_on = s.in.has("ON");
  const bool is_understood = is_on != s.in.has("OFF");
  if (!is_understood) s.in.count_unknown();
  if (!is_understood || !s.skips_more_than_motion) {
    switch_doubt(s, Doubt::skip, is_on || !is_understood, Reasons::kSkipped);
    s.skips_more_than_motion = !is_understood;
  }
}

// A code that ends a shift need not end the one that began it; those that end cycles and steps end all there
// are.
void take_machine_text(States& s, const MachineEffect& effect) {
  const bool is_other_unit = effect.unit && std::abs(mm_per(*effect.unit) - s.frame.mm_per_unit()) > 0;
  const bool moves = effect.moves || effect.changes_tool || effect.is_unknown;
  const bool shifts = effect.shifts || is_other_unit;
  if (effect.chooses_offset) s.offsets_chosen.add(s.in.line());
  if (moves || shifts || effect.changes_length || effect.begins_cycle || effect.begins_steps) s.in.count_unknown();
  if (moves) emit_unread(s);
  const auto doubt = [&](Doubt which, const char* reason) { s.doubts.set(which, s.in.because(reason)); };
  if (effect.changes_length) doubt(Doubt::loading, Reasons::kMachineShift);
  if (effect.changes_tool) doubt(Doubt::loading, Reasons::kUnreadTool);
  if (shifts) doubt(Doubt::machine_shift, Reasons::kMachineShift);
  if (effect.ends_cycle) s.doubts.clear(Doubt::machine_cycle);
  if (effect.begins_cycle) doubt(Doubt::machine_cycle, Reasons::kMachineCycle);
  if (effect.ends_steps) s.doubts.clear(Doubt::machine_steps);
  if (effect.begins_steps) doubt(Doubt::machine_steps, Reasons::kMachineSteps);
}

// SolidWorks CAM names tools, setups and stock here, Mastercam writes comments into its manual entries.
void take_insert(States& s) {
  s.tool.take_insert(s.in.first_piece());
  take_machine_text(s, read_machine_text(s.in.first_piece(), s.in.dialect.inserts_are_names));
}

void take_prefun(States& s) { take_codes(s, 'G'); }

// More numbers are the position of another line.
void take_auxfun(States& s) {
  const NumberCount numbers = count_numbers(s.in.arguments);
  if (numbers.count >= 3 || numbers.has_negative) return take_unread_motion(s);
  take_codes(s, 'M');
}

// SolidWorks CAM begins and ends its setups with SETUP/START,n and SETUP/END,n.
void take_setup(States& s) {
  const std::vector<Argument>& arguments = s.in.arguments;
  const bool is_mark =
      arguments.size() <= 2 && !arguments.empty() &&
      (equals_ignoring_case(arguments.front().text, "START") || equals_ignoring_case(arguments.front().text, "END"));
  if (is_mark || std::none_of(arguments.begin(), arguments.end(), may_be_number)) return;
  if (std::all_of(arguments.begin(), arguments.end(), is_zero)) return;
  s.in.count_unknown();
  s.doubts.set(Doubt::setup, s.in.because(Reasons::kSetup));
}

// SELECT/TOOL,n makes the next tool ready. An origin or a head changes where positions are.
void take_select(States& s) {
  if (s.in.arguments.empty() || equals_ignoring_case(s.in.arguments.front().text, "TOOL")) return;
  s.in.count_unknown();
  s.doubts.set(Doubt::setup, s.in.because(Reasons::kSetup));
}

}  // namespace gouge
