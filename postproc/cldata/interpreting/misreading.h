#pragma once

#include <cstdint>

#include "postproc/cldata/interpreting/states.h"
#include "postproc/cldata/language/dialect.h"
#include "postproc/cldata/language/statement.h"
#include "postproc/cldata/language/words.h"
#include "postproc/cldata/parsing/machine_text.h"

// Statements that are damaged, cut short or not understood. If they could have moved the tool, the moves that they
// could have changed are not checked.

// The modal states that statements of CL data leave in force, and the words that change such a state. One table for all
// readers; docs/formats/modal_states.md explains every row.

namespace gouge {

/// Returns whether a word has a digit, such as "9.X1" or "ANG1", so that it may have been a number.
[[nodiscard]] bool may_be_number(const Argument& argument);

/// Marks as unknown the states that a statement with this word would have changed.
void distrust(States& s, Word word);
/// Handles a feed rate whose numbers may be more than the rate and the number of its unit. The others may be a
/// position.
void distrust_numbers_of_feed(States& s);
/// Handles a statement that ends with a comma, has a blank within a possible number, or is a word without its necessary
/// arguments.
void distrust_cut_short(States& s);
/// Handles a statement at the end of a file without a line end: it may be the beginning of a longer one.
void distrust_last_line(States& s);
/// Handles, at the end of the file, a last position without the axis that the positions before it have.
void distrust_last_axis(States& s);
/// Applies the effects of a statement that is not understood: a line of numbers, a word joined to other characters, or
/// a misspelt word. They concern the statements before it, and the word that it was probably meant to be. Returns true
/// if it can only be more positions of the previous statement, so that the next one is certain again.
[[nodiscard]] bool take_misread(States& s, std::string_view text);
/// Marks all facts stated before `statement`, whose word is `major`, as uncertain: see Uncertainty::unknown.
void mark_all_uncertain(States& s, std::string_view major, std::size_t statement);
/// Handles a statement that is not understood at all.
void take_unknown_statement(States& s);
/// Handles a statement with an argument that the reader of its word does not know: it is not understood.
void distrust_arguments(States& s);

/// Applies the possible effects of text for the machine's control.
void take_machine_text(States& s, const MachineEffect& effect);

enum class ModalState : std::uint8_t {
  cycle,           ///< CYCLE/DRILL and similar words: positions are holes
  described_arc,   ///< CIRCLE, MOVARC, HELIX: the next position is the end of that curve
  start_tangent,   ///< INDIRV: the next TLON begins along it
  rapid,           ///< RAPID: the motion to the next position is rapid
  cutter_centre,   ///< OUTPUT_ON_CENTER of Creo: positions under CUTCOM are those of the cutter's centre
  motion_run,      ///< always open: positions that one state could include if it was switched on
  block_skip,      ///< OPSKIP/ON: the control may skip the rest
  between_blocks,  ///< after END-OF-PATH of NX: no TOOL PATH states a frame, a tool and an axis
};

/// Effect of a word on a modal state that is open.
enum class ModalEffect : std::uint8_t {
  none,
  ends,         ///< the state is no longer in force, in the normal manner of files
  contradicts,  ///< the state should have ended or been used before: the rest has more than one reading
};

inline constexpr ModalState kModalStates[] = {
    ModalState::cycle,         ModalState::described_arc, ModalState::start_tangent, ModalState::rapid,
    ModalState::cutter_centre, ModalState::motion_run,    ModalState::block_skip,    ModalState::between_blocks};

/// Returns the word by which `statement` acts. That is its own word. For a comment that is a statement, it is the word
/// of another dialect with the same effect.
[[nodiscard]] Word acting_word(const Statement& statement, CommentForm comments);

/// Returns the effect of `word` on `state`. `is_used`: a position was read under the state.
[[nodiscard]] ModalEffect effect_on(ModalState state, Word word, FeedInCycle feeds, bool is_used);

struct States;

/// Applies the effects of `word` to all states in force, before the statement's own handler runs.
void apply_modal_states(States& s, Word word);

}  // namespace gouge
