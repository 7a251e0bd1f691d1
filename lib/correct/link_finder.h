#pragma once

#include <array>
#include <optional>
#include <vector>

#include "lib/correct/clean_intervals.h"
#include "lib/correct/link.h"

namespace gouge {

/// A waypoint and the instant of the programmed motion that it represents.
struct LinkNode {
  LinkPose stop;
  double t = 0;
  [[nodiscard]] const Pose& pose() const { return stop.corrected.pose; }
};
using LinkNodes = std::vector<LinkNode>;

/// The search behind link(). It tests whether the tool is inside a solid at certain places: the start of a path, each
/// inserted position, and each clean interval of the programmed motion. From these places on, a clean motion keeps the
/// tool outside.
class LinkFinder {
 public:
  explicit LinkFinder(const LinkTask& task) : task_(task) {}

  /// Returns the positions strictly between `u` and `v`; nothing if no path was found.
  std::optional<LinkNodes> find(const LinkNode& u, const LinkNode& v);

 private:
  static constexpr int kLevels = 7;                 // number of halvings of a motion before another path is tried
  static constexpr std::size_t kMaxPositions = 24;  // maximum number of positions in one gap

  /// One side of a gap: a position, or the end of a clean interval, of which any instant is possible.
  struct GapEnd {
    LinkNode node;
    TimeInterval room;
    bool is_fixed = true;
  };
  enum class Search { simple, thorough };

  // link.cpp: a path between two positions
  std::optional<LinkNodes> find_feed(const LinkNode& u, const LinkNode& v);
  std::optional<LinkNodes> halve(const LinkNode& u, const LinkNode& v, int level);
  std::optional<LinkNodes> corner(const LinkNode& u, const LinkNode& v, double depth_mm);
  std::optional<LinkNodes> over(const LinkNode& from, const LinkNode& to, double clearance_mm);
  [[nodiscard]] std::array<double, 2> lifts_to_level(const Pose& from, const Pose& to) const;
  [[nodiscard]] std::vector<double> lifts_of_way(const Pose& from, const Pose& to) const;
  /// Returns the checker for motions that keep `room_mm` from stock too, if it is not 0.
  [[nodiscard]] MotionChecker checker_with(double room_mm) const;
  std::optional<LinkNodes> find_rapid(const LinkNode& u, const LinkNode& v);
  std::optional<LinkNodes> round(const LinkNode& u, const LinkNode& v, double air_mm);
  [[nodiscard]] PoseLimits limits() const;
  void leave_out_needless(const Pose& from, const Pose& to, LinkNodes& waypoints) const;
  [[nodiscard]] bool is_clean(const Pose& from, const Pose& to, double clearance_mm = 0) const;
  [[nodiscard]] bool is_between(const Pose& from, const Pose& to, const Pose& pose) const;
  [[nodiscard]] Motion motion_between(const Pose& from, const Pose& to) const;
  [[nodiscard]] MoveVerdict check(const Motion& motion) const;

  // leave_contact.cpp: a straight rapid from or to a contact
  [[nodiscard]] bool keeps_beyond_contacts(const Pose& from, const Pose& to) const;
  [[nodiscard]] std::optional<double> way_to_leave_mm(const Pose& from, const Pose& to) const;
  [[nodiscard]] bool is_leaving(const Pose& from, const Pose& away) const;

  // keep_to_programmed.cpp: a path that stays on the programmed motion where that is clean
  std::optional<LinkNodes> keep_to_programmed(const LinkNode& u, const LinkNode& v);
  std::optional<std::size_t> chain(const LinkNode& u, const LinkNode& v, LinkNodes& waypoints);
  [[nodiscard]] bool cross_straight(GapEnd& left, GapEnd& right) const;
  std::optional<LinkNodes> cross(GapEnd& left, GapEnd& right);
  std::optional<LinkNodes> link_ends(const GapEnd& left, const GapEnd& right, double left_t, double right_t,
                                     Search search);
  void drop_interval(std::size_t gap);
  void leave_out_holds(const LinkNode& u, const LinkNode& v, LinkNodes& waypoints) const;
  [[nodiscard]] bool stays_near(const LinkNode& from, const LinkNode& to) const;
  [[nodiscard]] LinkNode hold(double t) const;
  [[nodiscard]] Vec3 offset_mm(const LinkNode& node) const;
  [[nodiscard]] bool is_on_programmed(const LinkNode& node) const;
  [[nodiscard]] std::vector<TimeInterval> clean_programmed() const;

  const LinkTask& task_;
  std::vector<TimeInterval> clean_;  // clean intervals of the programmed motion, without those that no path reaches or
                                     // leaves
  std::size_t count_ = 0;            // number of positions found since the last start
  double air_mm_ = 0;                // the current clearance
  bool is_blocked_ = false;          // the way up or down of the last lift is blocked
};

/// Returns a waypoint at `after` for a motion that was at `before`; `lift_mm` is the distance between them.
[[nodiscard]] LinkPose link_stop(const Pose& before, const Pose& after, double lift_mm, double depth_mm);

}  // namespace gouge
