#pragma once

#include <optional>

#include "postproc/program/path_builder.h"

namespace gouge {

/// Position of the tool, and the connection of the next motion with the last one.
class MotionChain {
 public:
  explicit MotionChain(PathBuilder& builder) : builder_(builder) {}

  /// Returns the last pose in part coordinates; nothing: no motion leads to the next position.
  [[nodiscard]] const std::optional<Pose>& last_pose() const { return last_pose_; }
  /// Returns why the start of the next motion is unknown, or null.
  [[nodiscard]] const char* unknown_start() const { return unknown_start_; }
  /// Returns why the place of the last position is unknown, or null.
  [[nodiscard]] const char* last_uncertainty() const { return last_uncertainty_; }
  [[nodiscard]] bool is_start_certain() const {
    return last_pose_ && unknown_start_ == nullptr && last_uncertainty_ == nullptr;
  }
  [[nodiscard]] bool was_from() const { return was_from_; }

  void lose_start(const char* reason) { unknown_start_ = reason; }
  /// Makes the next motion start at last_pose() after all.
  void find_start() { unknown_start_ = nullptr; }
  /// Marks the start of the next motion as unknown if there is a last pose, or else that of a link.
  void lose_last_pose(const char* reason) { (last_pose_ ? unknown_start_ : lost_start_) = reason; }
  /// Breaks the motion: nothing is swept from the last position to the next.
  void break_off();
  /// Forbids a link: the tool may not have been at the last position when it moved to the next one.
  void forbid_link() { can_link_ = false; }
  /// Allows a link that was allowed in an earlier state of the chain, since which the tool may not have moved.
  void keep_link(const MotionChain& before) {
    if (!before.can_link_) return;
    can_link_ = true;
    if (lost_start_ == nullptr) lost_start_ = before.lost_start_;
  }
  /// Makes the end of `move`, which is about to become the last move, the last pose. `uncertainty` is why that place is
  /// unknown, or null. Links the move to the last one if the same tool was there; where the tool was after that one is
  /// unknown, the move is not checked. Returns whether the file states no way at all to it.
  bool advance(Move& move, const char* uncertainty);
  /// Handles a motion with an unknown end, which is reported at `end`.
  void stand(const Pose& end, const char* reason);
  void note_from(bool is_from) { was_from_ = is_from; }
  void write_note() const;

 private:
  void attach_link(Move& move);

  PathBuilder& builder_;
  std::optional<Pose> last_pose_;
  const char* unknown_start_ = nullptr;
  const char* last_uncertainty_ = nullptr;
  bool was_from_ = false;  // whether the last move was a FROM
  bool is_broken_ = false;
  bool can_link_ = false;             // the motion was broken at or after the end of the last move
  const char* lost_start_ = nullptr;  // why the place at which the motion was broken is unknown, or null
  Tally not_swept_;
};

}  // namespace gouge
