#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "lib/motion/axis_law.h"
#include "lib/motion/motion.h"
#include "lib/path/run_kind.h"
#include "lib/path/toolpath.h"

namespace gouge {

enum class RapidMode { straight, dogleg, skip };
/// Their words in options, results and the library, in this order.
inline constexpr std::array<const char*, 3> kRapidWords = {"straight", "dogleg", "skip"};
[[nodiscard]] constexpr const char* rapid_word(RapidMode mode) { return kRapidWords[static_cast<std::size_t>(mode)]; }
/// Returns the mode of a word; none: not one of these.
[[nodiscard]] constexpr std::optional<RapidMode> rapid_called(std::string_view word) {
  for (std::size_t k = 0; k < kRapidWords.size(); ++k) {
    if (word == kRapidWords[k]) return static_cast<RapidMode>(k);
  }
  return std::nullopt;
}

/// Law of the tool between the positions of a path: all that makes motions. The tip follows the path, on rapids
/// the mode. The axis turns on the great circle (the meaning of CL data) or by an AxisLaw.
class MotionLaw {
 public:
  /// The great circle. Skipped rapids are straight where a caller requests them nevertheless.
  MotionLaw(RapidMode rapid = RapidMode::straight)  // NOLINT(google-explicit-constructor): a mode is a law
      : rapid_(rapid) {}
  /// `axes`: not null; for feeds and rapids.
  MotionLaw(RapidMode rapid, std::shared_ptr<const AxisLaw> axes)
      : rapid_(rapid), feed_axes_(axes), rapid_axes_(axes) {}
  /// Laws for feeds and for rapids; null: the great circle.
  MotionLaw(RapidMode rapid, std::shared_ptr<const AxisLaw> feed_axes, std::shared_ptr<const AxisLaw> rapid_axes)
      : rapid_(rapid), feed_axes_(std::move(feed_axes)), rapid_axes_(std::move(rapid_axes)) {}

  /// Adds the laws that admit any motion of the rotary joints, for feeds and for rapids; null: the tip of such a move may
  /// leave its line or curve.
  void set_widest(std::shared_ptr<const AxisLaw> feed_axes, std::shared_ptr<const AxisLaw> rapid_axes) {
    widest_feed_axes_ = std::move(feed_axes);
    widest_rapid_axes_ = std::move(rapid_axes);
  }
  /// Adds the laws of moves without tool centre point control (Move::runs_joints), for feeds and for rapids; not null.
  /// Without this the tip of such a move runs straight.
  void set_joint_axes(std::shared_ptr<const AxisLaw> feed_axes, std::shared_ptr<const AxisLaw> rapid_axes) {
    joint_feed_axes_ = std::move(feed_axes);
    joint_rapid_axes_ = std::move(rapid_axes);
  }
  /// Returns the law of set_widest for both kinds of moves. None: there is none for either kind. A kind without
  /// one keeps its law.
  [[nodiscard]] std::optional<MotionLaw> widest() const;
  [[nodiscard]] bool has_widest(MoveKind kind) const {
    return (kind == MoveKind::rapid ? widest_rapid_axes_ : widest_feed_axes_) != nullptr;
  }

  [[nodiscard]] RapidMode rapid() const { return rapid_; }
  /// Returns true where the motion between the poses at two instants of a motion without a curve is surely a part of
  /// it.
  [[nodiscard]] bool is_divisible(MoveKind kind) const { return is_divisible(axes_of(kind), kind); }
  /// Returns the same for the motion of a move.
  [[nodiscard]] bool is_divisible(const Move& move) const { return is_divisible(axes_of(move), run_kind(move)); }
  /// Returns true where the axis turns on the great circle in all motions.
  [[nodiscard]] bool is_great_circle() const {
    return is_on_circle(feed_axes_.get()) && is_on_circle(rapid_axes_.get()) && joint_feed_axes_ == nullptr;
  }
  /// Returns true where the axis of a move runs by an AxisLaw.
  [[nodiscard]] bool is_by_axes(const Move& move) const { return axes_of(move) != nullptr; }
  /// Returns whether a rapid and a feed between the ends of a move without a curve may run differently.
  [[nodiscard]] bool has_other_rapid(const Toolpath& toolpath, std::size_t move) const;
  /// Names the reason for which the law leaves the motion of a move with a start open; empty: it does not, or opposite axes are the reason.
  [[nodiscard]] std::string why_open(const Toolpath& toolpath, std::size_t move) const;
  /// True where the tip may leave its line while the axis stands.
  [[nodiscard]] bool bends_without_turning() const;
  /// Names the law of the axis: "great-circle", or as the AxisLaw does, for feeds and rapids.
  [[nodiscard]] std::string name() const;

  /// Makes the motion of a move, along its arc or spline where it has one.
  [[nodiscard]] Motion of(const Toolpath& toolpath, std::size_t move) const;
  /// Returns the straight motion to a position alone from where the tool was before it (Move::is_linked); nothing where
  /// the path has no link there. The file does not state it; the check only tests whether it is clean.
  [[nodiscard]] std::optional<Motion> link_of(const Toolpath& toolpath, std::size_t move) const;
  /// Makes the motion of a tool that rests at a pose.
  [[nodiscard]] Motion at(const Pose& pose) const;
  /// Returns the same for a tool alone: a solid of revolution, which stands alike under every law.
  [[nodiscard]] static Motion tool_at(const Pose& pose) { return MotionLaw().at(pose); }
  /// Returns the motion between two positions with no curve: by the mode for rapids, straight otherwise.
  [[nodiscard]] Motion between(const Pose& from, const Pose& to, MoveKind kind) const;
  [[nodiscard]] Motion straight(const Pose& from, const Pose& to) const { return {from, to, feed_axes_.get()}; }
  [[nodiscard]] Motion along(const Pose& from, const Pose& to, const PathArc& arc) const;
  /// Requires at least one piece.
  [[nodiscard]] Motion along(const Pose& from, const Pose& to, const PathSpline& spline) const;

 private:
  static bool is_on_circle(const AxisLaw* axes) { return axes == nullptr || axes->scope() == LawScope::circle; }
  [[nodiscard]] bool is_divisible(const AxisLaw* axes, MoveKind kind) const {
    return axes == nullptr && (kind != MoveKind::rapid || rapid_ != RapidMode::dogleg);
  }
  /// Returns the law of a move. No other function decides it.
  [[nodiscard]] const AxisLaw* axes_of(const Move& move) const { return axes_of(move, run_kind(move)); }
  /// Returns the law by which a move would run as one of a kind.
  [[nodiscard]] const AxisLaw* axes_of(const Move& move, MoveKind kind) const {
    if (!move.runs_joints || joint_feed_axes_ == nullptr) return axes_of(kind);
    return kind == MoveKind::rapid ? joint_rapid_axes_.get() : joint_feed_axes_.get();
  }
  [[nodiscard]] const AxisLaw* axes_of(MoveKind kind) const {
    return kind == MoveKind::rapid ? rapid_axes_.get() : feed_axes_.get();
  }

  RapidMode rapid_;
  std::shared_ptr<const AxisLaw> feed_axes_, rapid_axes_, widest_feed_axes_, widest_rapid_axes_, joint_feed_axes_,
      joint_rapid_axes_;
};

}  // namespace gouge
