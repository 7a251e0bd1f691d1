#pragma once

#include <optional>
#include <vector>

#include "lib/correct/bridge.h"

namespace gouge {

/// A position of a way and the instant of the programmed motion that it stands for.
struct BridgeNode {
  BridgePose stop;
  double t = 0;
  [[nodiscard]] const Pose& pose() const { return stop.corrected.pose; }
};
using BridgeNodes = std::vector<BridgeNode>;

/// The search behind bridge(). Whether the tool is inside a solid is asked where a way begins and at each position put into
/// it; from there on a clean motion keeps it outside.
class Bridger {
 public:
  explicit Bridger(const BridgeTask& task) : task_(task) {}

  /// The positions strictly between `u` and `v`.
  std::optional<BridgeNodes> find(const BridgeNode& u, const BridgeNode& v);

 private:
  static constexpr int kLevels = 7;                   // halvings of a motion before another way is tried
  static constexpr std::size_t kMostPositions = 24;  // put into one motion

  std::optional<BridgeNodes> route(const BridgeNode& u, const BridgeNode& v, int level, bool keeps);
  std::optional<BridgeNodes> halve(const BridgeNode& u, const BridgeNode& v, int level, bool keeps);
  std::optional<BridgeNodes> along_programmed(const BridgeNode& u, const BridgeNode& v, int level);
  std::optional<BridgeNodes> joined(const BridgeNode& u, const BridgeNode& v, BridgeNodes holds, int level);
  std::optional<BridgeNodes> over(const BridgeNode& from, const BridgeNode& to, double clearance_mm);
  std::optional<BridgeNodes> over_gouge(const BridgeNode& u, const BridgeNode& v);
  void leave_out_needless(const Pose& from, const Pose& to, BridgeNodes& way) const;
  [[nodiscard]] BridgeNode hold(double t) const;
  [[nodiscard]] double off_mm(const BridgeNode& node) const;
  [[nodiscard]] bool is_clean_programmed(double t0, double t1) const;
  [[nodiscard]] bool is_free_programmed(double t) const;
  [[nodiscard]] double last_clean(double from, double towards) const;
  [[nodiscard]] bool is_clean(const Pose& from, const Pose& to, double clearance_mm = 0) const;
  [[nodiscard]] bool is_on_the_way(const Pose& from, const Pose& to, const Pose& pose) const;
  [[nodiscard]] Motion motion_between(const Pose& from, const Pose& to) const;
  [[nodiscard]] MoveVerdict check(const Motion& motion) const;

  const BridgeTask& task_;
  std::size_t count_ = 0;  // of positions found since the last start
};

}  // namespace gouge
