#include "postproc/program/motion_chain.h"

#include <utility>

namespace gouge {

// Breaks the motion. A FROM, a CUTTER or another sequence alone does not mean that the machine goes home between two
// positions.
void MotionChain::break_off() {
  is_broken_ = is_broken_ || last_pose_.has_value();
  if (last_pose_) can_link_ = unknown_start_ == nullptr && last_uncertainty_ == nullptr && !builder_.path.moves.empty();
  last_pose_.reset();
  unknown_start_ = nullptr;
  last_uncertainty_ = nullptr;
}

// Links a position without a start to the last one, unless the tool may have been changed before it. Such a change is
// another number, or a loading of another cutter.
void MotionChain::attach_link(Move& move) {
  const bool can_link = std::exchange(can_link_, false);
  const bool was_loaded = std::exchange(was_loaded_, false);
  const Toolpath& path = builder_.path;
  if (!can_link || move.has_start || move.tool == kNone || path.moves.back().tool == kNone) return;
  const std::size_t tool = path.moves.back().tool;
  const std::optional<int> before = path.tools[tool].number, now = path.tools[move.tool].number;
  move.is_linked = move.tool == tool || (before && before == now && !was_loaded);
}

void MotionChain::advance(Move& move, const char* uncertainty) {
  if (is_broken_) not_swept_.add(move.line);
  attach_link(move);
  is_broken_ = false;
  last_pose_ = move.end;
  last_uncertainty_ = uncertainty;
  unknown_start_ = nullptr;
  was_from_ = false;
}

void MotionChain::stand(const Pose& end, const char* reason) {
  last_pose_ = end;
  unknown_start_ = reason;
  was_from_ = false;
}

void MotionChain::write_note() const {
  builder_.report(
      Severity::note, "path-not-swept", not_swept_, "time",
      " the machine goes home or changes its tool, frame or sequence between two positions: nothing is swept there");
}

}  // namespace gouge
