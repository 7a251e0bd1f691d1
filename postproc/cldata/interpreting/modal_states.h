#pragma once

#include <cstdint>

#include "postproc/cldata/language/dialect.h"
#include "postproc/cldata/language/statement.h"
#include "postproc/cldata/language/words.h"

// What a statement of CL data leaves in force for those after it, and which words say that it no longer is what it
// was. One table for all readers: docs/formats/modal_states.md explains every row.

namespace gouge {

enum class ModalState : std::uint8_t {
  cycle,           ///< CYCLE/DRILL and its like: positions are holes
  described_arc,   ///< CIRCLE, MOVARC, HELIX: the next position is the end of that curve
  start_tangent,   ///< INDIRV: the next TLON leaves along it
  rapid,           ///< RAPID: the next position is reached at rapid
  cutter_centre,   ///< Creo's OUTPUT_ON_CENTER: positions under CUTCOM are the cutter's centre
  motion_run,      ///< always open: positions that one switched-on state could span
  block_skip,      ///< OPSKIP/ON: what follows is run or not
  between_blocks,  ///< after END-OF-PATH of NX: no TOOL PATH gives a frame, a tool and an axis
};

/// What a word does to a modal state that is open.
enum class ModalEffect : std::uint8_t {
  none,
  ends,         ///< the state is no longer in force, as files write it
  contradicts,  ///< the state should have ended or been used before: what follows has more than one reading
};

inline constexpr ModalState kModalStates[] = {
    ModalState::cycle,         ModalState::described_arc, ModalState::start_tangent, ModalState::rapid,
    ModalState::cutter_centre, ModalState::motion_run,    ModalState::block_skip,    ModalState::between_blocks};

/// What `statement` acts as: its word, or for comments that are statements the word of another dialect that does the
/// same.
[[nodiscard]] Word acting_word(const Statement& statement, CommentForm comments);

/// What `word` does to `state`. `is_used`: a position has been read under the state.
[[nodiscard]] ModalEffect effect_on(ModalState state, Word word, FeedInCycle feeds, bool is_used);

struct States;

/// What `word` does to all that is in force, before the statement's own handler has its turn.
void apply_modal_states(States& s, Word word);

}  // namespace gouge
