#pragma once

#include "postproc/cldata/interpreting/states.h"

// Further possible readings of the last move, as moves of their own: docs/formats/modal_states.md. Each is called
// behind the move it is about, but settle_retract.

namespace gouge {

void emit_one_turn_more(States& s, const Position& position);
void emit_from_before_skip(States& s, const Position& position);
void emit_from_retract(States& s, const Position& position);
void emit_from_open_places(States& s, const Position& position);
/// Before the move to `position`, whose start it may find.
void settle_retract(States& s, const Position& position);

}  // namespace gouge
