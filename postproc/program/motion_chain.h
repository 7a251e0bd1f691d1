#pragma once

#include <optional>

#include "postproc/program/path_builder.h"

namespace gouge {

/// Place of the tool, and the connection of the next motion with the last one.
class MotionChain {
 public:
  explicit MotionChain(PathBuilder& builder) : builder_(builder) {}

  /// Returns the last pose in part coordinates; nothing: the next position is alone.
  [[nodiscard]] const std::optional<Pose>& last_pose() const { return last_pose_; }
  /// Returns why the next motion's start is not known, or null.
  [[nodiscard]] const char* unknown_start() const { return unknown_start_; }
  /// Returns why the last position was an unknown place, or null.
  [[nodiscard]] const char* last_uncertainty() const { return last_uncertainty_; }
  [[nodiscard]] bool is_start_certain() const {
    return last_pose_ && unknown_start_ == nullptr && last_uncertainty_ == nullptr;
  }
  [[nodiscard]] bool was_from() const { return was_from_; }

  void lose_start(const char* reason) { unknown_start_ = reason; }
  /// The next motion starts at last_pose() after all.
  void find_start() { unknown_start_ = nullptr; }
  /// Returns where there is one.
  void lose_last_pose(const char* reason) {
    if (last_pose_) unknown_start_ = reason;
  }
  /// Nothing is swept from the last position to the next.
  void break_off();
  /// Nor was the tool at the last position before it came to the next one.
  void forbid_link() { can_link_ = false; }
  void note_loading() { was_loaded_ = true; }
  /// `move` is about to become the last one; `doubt` is why it is an unknown place, or null.
  void advance(Move& move, const char* uncertainty);
  /// A motion of unknown end.
  void stand(const Pose& end, const char* reason);
  void note_from(bool is_from) { was_from_ = is_from; }
  void write_note() const;

 private:
  void attach_link(Move& move);

  PathBuilder& builder_;
  std::optional<Pose> last_pose_;
  const char* unknown_start_ = nullptr;
  const char* last_uncertainty_ = nullptr;
  bool was_from_ = false;  // the last move was FROM
  bool is_broken_ = false;
  bool can_link_ = false;    // the motion broke off at the end of the last move
  bool was_loaded_ = false;  // a tool was loaded since the last move
  Tally not_swept_;
};

}  // namespace gouge
