#pragma once

#include <cstdint>

#include "postproc/cldata/interpreting/states.h"
#include "postproc/cldata/language/dialect.h"
#include "postproc/cldata/language/statement.h"
#include "postproc/cldata/language/words.h"
#include "postproc/cldata/parsing/machine_text.h"

// Statements that are damaged, cut short or not understood: where they could have moved the tool, the moves they could
// have changed are not checked.

// The modal states that a statement of CL data leaves in force, and the words that state that one no longer is what it
// was. One table for all readers: docs/formats/modal_states.md explains every row.

namespace gouge {

/// Returns whether a word such as "9.X1" or "ANG1" holds a digit, so that it may have been a number.
[[nodiscard]] bool may_be_number(const Argument& argument);

/// Makes the states unknown that a statement of this word would have changed.
void distrust(States& s, Word word);
/// Handles a feed rate with a possible number of its unit, and behind them a possible position.
void distrust_numbers_of_feed(States& s);
/// A statement that ends with a comma, has blanks within what may be one number, or a word alone that states nothing
/// so.
void distrust_cut_short(States& s);
/// A statement at the end of a file that has no line end there: it may be the beginning of a longer one.
void distrust_last_line(States& s);
/// At the end of the file: its last position lacks the axis that those before it have.
void distrust_last_axis(States& s);
/// Applies the effects of a statement that is not understood, on those before it and on the word it was meant to be. It
/// is a line of numbers, a word joined to other characters, or a misspelt word. True where it can only be more
/// positions of the statement before it, so that the next one is certain again.
[[nodiscard]] bool take_misread(States& s, std::string_view text);
/// Makes all facts stated before `statement`, whose word is `major`, uncertain: see Uncertainty::unknown.
void mark_all_uncertain(States& s, std::string_view major, std::size_t statement);
/// The statement being taken is not understood at all.
void take_unknown_statement(States& s);
/// So is it where the reader of its word does not know one of its arguments.
void distrust_arguments(States& s);

/// Applies the possible effects of text for the machine's control.
void take_machine_text(States& s, const MachineEffect& effect);

enum class ModalState : std::uint8_t {
  cycle,           ///< CYCLE/DRILL and its like: positions are holes
  described_arc,   ///< CIRCLE, MOVARC, HELIX: the next position is the end of that curve
  start_tangent,   ///< INDIRV: the next TLON leaves along it
  rapid,           ///< RAPID: the next position is reached at rapid
  cutter_centre,   ///< Creo's OUTPUT_ON_CENTER: positions under CUTCOM are the cutter's centre
  motion_run,      ///< always open: positions that one switched-on state could span
  block_skip,      ///< OPSKIP/ON: the control runs the rest or not
  between_blocks,  ///< after END-OF-PATH of NX: no TOOL PATH gives a frame, a tool and an axis
};

/// Effect of a word on a modal state that is open.
enum class ModalEffect : std::uint8_t {
  none,
  ends,         ///< the state is no longer in force, as files write it
  contradicts,  ///< the state should have ended or been used before: the rest has more than one reading
};

inline constexpr ModalState kModalStates[] = {
    ModalState::cycle,         ModalState::described_arc, ModalState::start_tangent, ModalState::rapid,
    ModalState::cutter_centre, ModalState::motion_run,    ModalState::block_skip,    ModalState::between_blocks};

/// Returns the word that `statement` acts as: its own, or for comments that are statements the word of another dialect
/// that does the same.
[[nodiscard]] Word acting_word(const Statement& statement, CommentForm comments);

/// Returns the effect of `word` on `state`. `is_used`: a position has been read under the state.
[[nodiscard]] ModalEffect effect_on(ModalState state, Word word, FeedInCycle feeds, bool is_used);

struct States;

/// Applies the effects of `word` to all states in force, before the statement's own handler has its turn.
void apply_modal_states(States& s, Word word);

}  // namespace gouge
