#include "postproc/program/motion_chain.h"

#include <utility>

namespace gouge {

namespace {

// Returns whether two tools are one tool in the spindle. Its number identifies a tool; the same number in other words
// loads no other tool. Without numbers the name does.
bool is_same_tool(const PathTool& before, const PathTool& now) {
  if (before.number && now.number) return before.number == now.number;
  return !before.name.empty() && before.name == now.name;
}

}  // namespace

// Breaks the motion. A FROM, a frame, a CUTTER or another sequence alone does not mean that the machine goes home between
// two positions.
void MotionChain::break_off() {
  is_broken_ = is_broken_ || last_pose_.has_value();
  if (last_pose_) {
    can_link_ = last_uncertainty_ == nullptr && !builder_.path.moves.empty();
    lost_start_ = unknown_start_;
  }
  last_pose_.reset();
  unknown_start_ = nullptr;
  last_uncertainty_ = nullptr;
}

void MotionChain::attach_link(Move& move) {
  const bool can_link = std::exchange(can_link_, false);
  const char* const lost_start = std::exchange(lost_start_, nullptr);
  const Toolpath& path = builder_.path;
  if (!can_link || move.has_start || move.tool == kNone || path.moves.back().tool == kNone) return;
  const std::size_t before = path.moves.back().tool;
  if (before != move.tool && !is_same_tool(path.tools[before], path.tools[move.tool])) return;
  if (lost_start == nullptr) {
    move.is_linked = true;
  } else if (move.not_checked_reason.empty() || move.is_covered()) {
    move.not_checked_reason = lost_start;
    move.cover = Cover::none;
  }
}

bool MotionChain::advance(Move& move, const char* uncertainty) {
  const bool is_alone = !last_pose_;
  if (is_broken_) not_swept_.add(move.line);
  attach_link(move);
  is_broken_ = false;
  last_pose_ = move.end;
  last_uncertainty_ = uncertainty;
  unknown_start_ = nullptr;
  was_from_ = false;
  return is_alone && !move.is_linked;
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
