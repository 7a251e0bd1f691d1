#pragma once

#include "postproc/cldata/interpreting/states.h"

// Further possible readings of the last move, as moves of their own: docs/formats/modal_states.md. All functions except
// settle_retract are called after the move that they concern.

namespace gouge {

/// Makes the last move clean only if its other readings are clean.
void open_last_move(States& s, const char* reason);
/// Appends a reading. It has no position of its own, so it is not written.
void push_reading(States& s, const Position& position, Move move);
void emit_one_turn_more(States& s, const Position& position);
/// Adds the reading from the position before a block skip, which may be the start of the last move.
void emit_from_before_skip(States& s, const Position& position);

/// Leaves the last of the first `moves` moves unchecked, unless it is where the skip begins: its way to the next tool or home is
/// not stated, and the control may take it from the position before the skip.
void lose_way_behind_skip(States& s, std::size_t moves);
/// Finds the start of the straight motion to `position` from the last position of a block skip, if the motion from the
/// position before the skip is checked too.
void find_start_behind_skip(States& s, const Position& position);
/// Finds the last position of a block skip, so that a position behind a break is linked to it.
void find_start_for_link(States& s);
/// Marks all positions behind the skip in force as unknown, because a statement in it changes more than motion.
void contradict_skip(States& s);
void emit_from_retract(States& s, const Position& position);
void emit_from_open_places(States& s, const Position& position);
/// Settles an open retraction before the move to `position`, and may find the start of that move.
void settle_retract(States& s, const Position& position);

}  // namespace gouge
