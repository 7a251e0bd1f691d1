#pragma once

#include "postproc/cldata/interpreting/states.h"
#include "postproc/cldata/parsing/machine_text.h"

// Statements that are damaged, cut short or not understood: where they could have moved the tool, the moves they could
// have changed are not checked.

namespace gouge {

/// "9.X1", "ANG1": what holds a digit may have been a number.
[[nodiscard]] bool may_be_number(const Argument& argument);

/// What a statement of this word would have changed is not known any more.
void distrust(States& s, Word word);
/// A feed rate with what may be its unit's number, and behind them what may be a position.
void distrust_numbers_of_feed(States& s);
/// A statement that ends with a comma, or has a word alone that says nothing so.
void distrust_cut_short(States& s);
/// A line of numbers, a word that something was glued to or that is misspelt, or a block of a control that does
/// something: then true.
[[nodiscard]] bool take_misread(States& s, std::string_view text);

/// What text for the machine's control may have done.
void take_machine_text(States& s, const MachineEffect& effect);

}  // namespace gouge
