#include "postproc/cldata/interpreting/emit.h"
#include "postproc/cldata/interpreting/modal_states.h"

// The table of modal_states.h applied to what is in force.

namespace gouge {
namespace {

bool is_open(const States& s, ModalState state) {
  switch (state) {
    case ModalState::cycle:
      return s.cycle.is_on();
    case ModalState::described_arc:
      return s.curve.arc().has_value();
    case ModalState::start_tangent:
      return s.curve.has_tangent();
    case ModalState::rapid:
      return s.feed.is_rapid();
    case ModalState::cutter_centre:
      return s.cutcom.is_centre();
    case ModalState::motion_run:
      return true;
    case ModalState::block_skip:
      return s.doubts.has(Doubt::skip);
    case ModalState::between_blocks:
      return s.blocks.is_between();
  }
  return false;
}

void end_state(States& s, ModalState state) {
  switch (state) {
    case ModalState::rapid:
      return s.feed.end_rapid();
    case ModalState::cutter_centre:
      return s.cutcom.end_centre();
    case ModalState::motion_run:
      s.run_begin = s.in.moves();
      return;
    case ModalState::between_blocks:
      return s.blocks.leave_between();
    default:
      return;
  }
}

void contradict(States& s, ModalState state) {
  switch (state) {
    case ModalState::cycle:
      return s.cycle.contradict();
    case ModalState::described_arc:
    case ModalState::start_tangent:
      return drop_described_curve(s);
    case ModalState::block_skip:
      s.skips_more_than_motion = true;
      return;
    case ModalState::between_blocks:
      return s.blocks.note_frame_between();
    default:
      return;
  }
}

}  // namespace

void apply_modal_states(States& s, Word word) {
  if (word == Word::go_to && !s.curve.has_tangent()) return;  // most of a file; of all rows only INDIRV's names it
  const FeedInCycle feeds = s.in.dialect.feed_in_cycle;
  for (const ModalState state : kModalStates) {
    if (!is_open(s, state)) continue;
    const bool is_used = state == ModalState::cycle && s.cycle.has_holes();
    const ModalEffect effect = effect_on(state, word, feeds, is_used);
    if (effect == ModalEffect::ends) end_state(s, state);
    if (effect == ModalEffect::contradicts) contradict(s, state);
  }
  // No cycle holds this word.
  if (effect_on(ModalState::cycle, word, feeds, true) == ModalEffect::contradicts) s.cycle.bound_holes();
}

}  // namespace gouge
