#pragma once

#include <optional>
#include <vector>

#include "lib/correct/bridge.h"
#include "lib/correct/clean_intervals.h"

namespace gouge {

/// A waypoint and the instant of the programmed motion that it stands for.
struct BridgeNode {
  BridgePose stop;
  double t = 0;
  [[nodiscard]] const Pose& pose() const { return stop.corrected.pose; }
};
using BridgeNodes = std::vector<BridgeNode>;

/// The search behind bridge(). Whether the tool is inside a solid is asked where a path begins, at each position put
/// into it and in each clean interval of the programmed motion; from there on a clean motion keeps it outside.
class Bridger {
 public:
  explicit Bridger(const BridgeTask& task) : task_(task) {}

  /// The positions strictly between `u` and `v`.
  std::optional<BridgeNodes> find(const BridgeNode& u, const BridgeNode& v);

 private:
  static constexpr int kLevels = 7;                  // halvings of a motion before another path is tried
  static constexpr std::size_t kMostPositions = 24;  // put into one gap

  /// One side of a gap: a position, or the end of a clean interval of which all instants will do.
  struct Shore {
    BridgeNode node;
    TimeInterval room;
    bool is_fixed = true;
  };
  enum class Search { simple, thorough };

  // bridge.cpp: a path between two positions
  std::optional<BridgeNodes> find_feed(const BridgeNode& u, const BridgeNode& v);
  std::optional<BridgeNodes> halve(const BridgeNode& u, const BridgeNode& v, int level);
  std::optional<BridgeNodes> corner(const BridgeNode& u, const BridgeNode& v, double depth_mm);
  std::optional<BridgeNodes> over(const BridgeNode& from, const BridgeNode& to, double clearance_mm);
  std::optional<BridgeNodes> find_rapid(const BridgeNode& u, const BridgeNode& v);
  std::optional<BridgeNodes> round(const BridgeNode& u, const BridgeNode& v, double air_mm);
  [[nodiscard]] PoseLimits limits() const;
  void leave_out_needless(const Pose& from, const Pose& to, BridgeNodes& waypoints) const;
  [[nodiscard]] bool is_clean(const Pose& from, const Pose& to, double clearance_mm = 0) const;
  [[nodiscard]] bool is_between(const Pose& from, const Pose& to, const Pose& pose) const;
  [[nodiscard]] Motion motion_between(const Pose& from, const Pose& to) const;
  [[nodiscard]] MoveVerdict check(const Motion& motion) const;

  // keep_to_programmed.cpp: a path that keeps to the programmed motion where that is clean
  std::optional<BridgeNodes> keep_to_programmed(const BridgeNode& u, const BridgeNode& v);
  std::optional<std::size_t> chain(const BridgeNode& u, const BridgeNode& v, BridgeNodes& waypoints);
  std::optional<BridgeNodes> cross(Shore& left, Shore& right);
  std::optional<BridgeNodes> cross_here(const Shore& left, const Shore& right, double left_t, double right_t,
                                        Search search);
  void drop_interval(std::size_t gap);
  void leave_out_holds(const BridgeNode& u, const BridgeNode& v, BridgeNodes& waypoints) const;
  [[nodiscard]] bool stays_near(const BridgeNode& from, const BridgeNode& to) const;
  [[nodiscard]] BridgeNode hold(double t) const;
  [[nodiscard]] Vec3 offset_mm(const BridgeNode& node) const;
  [[nodiscard]] bool is_on_programmed(const BridgeNode& node) const;
  [[nodiscard]] std::vector<TimeInterval> clean_programmed() const;

  const BridgeTask& task_;
  std::vector<TimeInterval> clean_;  // of the programmed motion, without those that nothing leads to or from
  std::size_t count_ = 0;            // of positions found since the last start
  double air_mm_ = 0;                // what is kept from everything now
};

/// A waypoint on a motion that was at `before`, `lift` away from it.
[[nodiscard]] BridgePose bridge_stop(const Pose& before, const Pose& after, double lift_mm, double depth_mm);

}  // namespace gouge
