#pragma once

#include "postproc/cldata/interpreting/states.h"

// Further possible readings of the last move, as moves of their own: docs/formats/modal_states.md. All functions except
// settle_retract are called after the move that they concern.

namespace gouge {

void emit_one_turn_more(States& s, const Position& position);
void emit_from_before_skip(States& s, const Position& position);
void emit_from_retract(States& s, const Position& position);
void emit_from_open_places(States& s, const Position& position);
/// Settles an open retraction before the move to `position`, and may find the start of that move.
void settle_retract(States& s, const Position& position);

}  // namespace gouge
