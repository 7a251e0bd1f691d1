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
/// A statement that ends with a comma, has blanks within what may be one number, or a word alone that says nothing so.
void distrust_cut_short(States& s);
/// A statement at the end of a file that has no line end there: it may be the beginning of a longer one.
void distrust_last_line(States& s);
/// At the end of the file: its last position lacks the axis that those before it have.
void distrust_last_axis(States& s);
/// What a statement that is not understood says of those before it and of the word that it was meant to be: a line of
/// numbers, a word that something was glued to or that is misspelt. True where it can only be more positions of the
/// statement before it, so that the next one is certain again.
[[nodiscard]] bool take_misread(States& s, std::string_view text);
/// Nothing that the file stated before `statement`, whose word is `major`, is certain any more: see Doubt::unknown.
void doubt_all(States& s, std::string_view major, std::size_t statement);
/// The statement being taken is not understood at all.
void take_unknown_statement(States& s);
/// So is it where the reader of its word does not know one of its arguments.
void distrust_arguments(States& s);

/// What text for the machine's control may have done.
void take_machine_text(States& s, const MachineEffect& effect);

}  // namespace gouge
