#include <algorithm>

#include "postproc/cldata/interpreting/interpreter.h"

// The table of modal_states.h applied to what is in force, before a statement's own reader has its turn.

namespace gouge {

void Interpreter::apply_modal_states(Word word) {
  if (word == Word::go_to && !has_indirv_) return;  // most of a file; of all rows only INDIRV's names it
  for (const ModalState state : kModalStates) {
    if (!is_open(state)) continue;
    switch (effect_on(state, word, dialect_.feed_in_cycle, is_used(state))) {
      case ModalEffect::none:
        break;
      case ModalEffect::ends:
        end_state(state);
        break;
      case ModalEffect::contradicts:
        contradict(state);
        break;
    }
  }
  // What no cycle holds bounds the moves that could be holes of one whose CYCLE is missing.
  const bool is_no_hole = effect_on(ModalState::cycle, word, dialect_.feed_in_cycle, true) == ModalEffect::contradicts;
  if (!cycle_.is_on && is_no_hole) cycle_.first_possible_hole = path_.moves.size();
}

bool Interpreter::is_open(ModalState state) const {
  switch (state) {
    case ModalState::cycle:
      return cycle_.is_on;
    case ModalState::described_arc:
      return arc_.has_value();
    case ModalState::start_tangent:
      return has_indirv_;
    case ModalState::rapid:
      return is_rapid_;
    case ModalState::cutter_centre:
      return is_cutter_centre_;
    case ModalState::motion_run:
      return true;
    case ModalState::between_blocks:
      return is_between_blocks_;
  }
  return false;
}

bool Interpreter::is_used(ModalState state) const {
  return state == ModalState::cycle && cycle_.first_positions != kNone;
}

void Interpreter::end_state(ModalState state) {
  switch (state) {
    case ModalState::rapid:
      is_rapid_ = false;
      break;
    case ModalState::cutter_centre:
      is_cutter_centre_ = is_cutter_centre_said_;
      break;
    case ModalState::motion_run:
      run_begin_ = path_.moves.size();
      break;
    case ModalState::between_blocks:
      is_between_blocks_ = false;
      break;
    default:
      break;
  }
}

void Interpreter::contradict(ModalState state) {
  switch (state) {
    case ModalState::cycle:
      if (!cycle_.is_contradicted) cycle_.contradicted_moves = path_.moves.size();
      cycle_.is_contradicted = true;  // told at the next position: before it nothing is lost
      break;
    case ModalState::described_arc:
    case ModalState::start_tangent:
      drop_described_curve();
      break;
    case ModalState::between_blocks:
      is_msys_outside_ = true;
      break;
    default:
      break;
  }
}

// An OFF that ends nothing: what it should end may have begun anywhere since the last tool, operation or OFF.
void Interpreter::doubt_run(const char* reason, std::size_t& run_begin) {
  const std::size_t begin = std::max(run_begin, run_begin_);
  run_begin = path_.moves.size();
  if (begin == run_begin) return;
  doubt_moves(begin, run_begin, because(reason));
  if (last_pose_) unknown_start_ = Reasons::kAfterUnread;
}

void Interpreter::doubt_moves(std::size_t begin, std::size_t end, std::string_view reason) {
  for (std::size_t i = begin; i < end; ++i) {
    std::string_view& own = path_.moves[i].not_checked_reason;
    if (own.empty()) own = reason;
  }
  for (auto open = open_arcs_.rbegin(); open != open_arcs_.rend() && open->move >= begin; ++open) {
    if (open->move < end && open->not_checked_reason.empty()) open->not_checked_reason = reason;
  }
}

// A motion that is announced and not finished: where it ends nobody knows.
void Interpreter::drop_described_curve() {
  const bool is_arc = arc_.has_value();
  arc_.reset();
  start_tangent_.reset();
  has_indirv_ = false;
  emit_unread(is_arc ? Reasons::kNoArcEnd : Reasons::kNoTlon, arc_statement_);
}

}  // namespace gouge
