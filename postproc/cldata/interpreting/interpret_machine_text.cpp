#include <algorithm>
#include <cmath>
#include <string>

#include "lib/base/number_text.h"
#include "lib/base/units.h"
#include "postproc/cldata/interpreting/interpreter.h"
#include "postproc/cldata/language/text.h"
#include "postproc/cldata/parsing/machine_text.h"

// Statements that carry text or codes for the machine's control, and choices of the setup: what of them may
// move the tool or change where positions are.

namespace gouge {
namespace {

bool has_digit(const Argument& argument) {
  return argument.number || argument.text.find_first_of("0123456789") != std::string_view::npos;
}

bool is_zero(const Argument& argument) {
  return argument.number && std::abs(*argument.number) <= 0;
}

}  // namespace

// SolidWorks CAM names tools, setups and stock here, Mastercam writes comments into its manual entries.
void Interpreter::take_insert() {
  const std::string_view text = statement_->pieces.front();
  last_insert_ = name_text(text);
  take_machine_text(read_machine_text(text, dialect_.inserts_are_names));
}

// PREFUN/g and AUXFUN/m are a G and an M of the control.
void Interpreter::take_codes(char letter) {
  for (const Argument& argument : arguments_) {
    const std::string code =
        argument.number ? letter + exact_text(*argument.number) : std::string(argument.text);
    MachineEffect effect = read_machine_text(code, false);
    effect.is_unknown = effect.is_unknown && argument.number.has_value();
    take_machine_text(effect);
  }
}

// A code that ends a shift need not end the one that began it; those that end cycles and steps end all there
// are.
void Interpreter::take_machine_text(const MachineEffect& effect) {
  const bool is_other_unit = effect.unit && std::abs(mm_per(*effect.unit) - mm_per_unit_) > 0;
  const bool moves = effect.moves || effect.changes_tool || effect.is_unknown;
  if (effect.chooses_offset) offsets_chosen_.add(statement_->line);
  if (moves || effect.shifts || effect.changes_length || effect.begins_cycle || effect.begins_steps || is_other_unit) count_unknown();
  if (moves) emit_unread();
  if (effect.changes_length) loading_reason_ = because(Reasons::kMachineShift);
  if (effect.changes_tool) loading_reason_ = because(Reasons::kUnreadTool);
  if (effect.shifts || is_other_unit) machine_shift_reason_ = because(Reasons::kMachineShift);
  if (effect.ends_cycle) machine_cycle_reason_ = nullptr;
  if (effect.begins_cycle) machine_cycle_reason_ = because(Reasons::kMachineCycle);
  if (effect.ends_steps) machine_steps_reason_ = nullptr;
  if (effect.begins_steps) machine_steps_reason_ = because(Reasons::kMachineSteps);
}

// SolidWorks CAM begins and ends its setups with SETUP/START,n and SETUP/END,n.
void Interpreter::take_setup() {
  const bool is_mark = arguments_.size() <= 2 && !arguments_.empty() &&
                       (equals_ignoring_case(arguments_.front().text, "START") ||
                        equals_ignoring_case(arguments_.front().text, "END"));
  if (is_mark || std::none_of(arguments_.begin(), arguments_.end(), has_digit)) return;
  if (std::all_of(arguments_.begin(), arguments_.end(), is_zero)) return;
  count_unknown();
  setup_reason_ = because(Reasons::kSetup);
}

// SELECT/TOOL,n makes the next tool ready. An origin or a head changes where positions are.
void Interpreter::take_select() {
  if (arguments_.empty() || equals_ignoring_case(arguments_.front().text, "TOOL")) return;
  count_unknown();
  setup_reason_ = because(Reasons::kSetup);
}

}  // namespace gouge
